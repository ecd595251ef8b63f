#include "machine/definition/tools/program_lines.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "base/decimal.hpp"
#include "machine/definition/tools/internal/letters.hpp"

namespace kerf::machine {
namespace {

constexpr std::size_t kLongestLine = 1000;
constexpr std::size_t kMostDigits = 8;

/// A line may begin in one piece of the file and end in a later one.
class LineJoiner {
 public:
  explicit LineJoiner(const std::function<void(std::string_view)>& take) : take_(take) {}

  void add(std::string_view piece) {
    for (std::size_t end = piece.find('\n'); end != std::string_view::npos;
         end = piece.find('\n')) {
      hand_on(piece.substr(0, end));
      piece.remove_prefix(end + 1);
    }
    begun_ += piece.substr(0, kLongestLine - std::min(kLongestLine, begun_.size()));
  }
  void finish() { hand_on({}); }

 private:
  void hand_on(std::string_view rest) {
    if (begun_.empty()) return take_(rest.substr(0, kLongestLine));
    begun_ += rest.substr(0, kLongestLine - std::min(kLongestLine, begun_.size()));
    take_(begun_);
    begun_.clear();
  }

  const std::function<void(std::string_view)>& take_;
  std::string begun_;
};

}  // namespace

void each_line(const base::SourceFile& program, const std::function<void(std::string_view)>& take) {
  LineJoiner joiner(take);
  std::array<char, 1 << 16> piece{};
  for (std::uint64_t at = 0; at < program.size();) {
    const std::size_t n = program.read(at, piece);
    if (n == 0) break;
    joiner.add({piece.data(), n});
    at += n;
  }
  joiner.finish();
}

ProgramLine::ProgramLine(std::string_view line, bool has_offset_in_t) {
  for (std::size_t i = 0; i < line.size();) {
    if (line[i] == ';') return;
    if (line[i] == '(') {
      const std::size_t end = std::min(line.find(')', i), line.size());
      comments_.push_back(line.substr(i + 1, end - i - 1));
      i = end + 1;
      continue;
    }
    const std::size_t begin = ++i;
    while (i < line.size() && is_digit(line[i])) ++i;
    if (i > begin)
      take_word(folded(line[begin - 1]), line.substr(begin, i - begin), has_offset_in_t);
  }
}

void ProgramLine::take_word(char letter, std::string_view digits, bool has_offset_in_t) {
  if (letter == 'G' && (digits == "20" || digits == "21")) inches_ = digits == "20";
  if (letter != 'T' || digits.size() > kMostDigits) return;
  const bool is_pair = has_offset_in_t && digits.size() > 2;
  if (is_pair) digits.remove_suffix(2);
  const auto number = base::read_whole_number(digits);
  if (number && *number > 0) tool_ = static_cast<int>(*number);
}

}  // namespace kerf::machine
