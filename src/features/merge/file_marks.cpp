#include "features/merge/file_marks.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "base/decimal.hpp"

namespace kerf::features {
namespace {

constexpr std::uint64_t kLargestFile = std::uint64_t{64} << 20U;

/// What means something of a line, in capitals.
std::string bare(std::string_view line) {
  std::string text;
  bool is_comment = false;
  for (const char c : line) {
    if (c == '(') is_comment = true;
    if (!is_comment && static_cast<unsigned char>(c) > ' ')
      text += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    if (c == ')') is_comment = false;
  }
  return text;
}

/// The digits behind a word of a line; nothing: it has no such word, or none behind it.
std::optional<std::uint64_t> number_behind(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    const std::size_t begin = at + word.size();
    std::size_t end = begin;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    if (end == begin) continue;
    if (const auto number = base::read_whole_number(text.substr(begin, end - begin)))
      return *number;
  }
  return std::nullopt;
}

/// Follows the lines of a file and keeps what is open.
class MarkReader {
 public:
  void take(std::string_view line, std::uint32_t number) {
    const std::string text = bare(line);
    std::string_view rest = text;
    while (!rest.empty() && rest.front() == '/') rest.remove_prefix(1);
    if (rest.empty()) return;
    if (rest.front() == 'O' || rest.front() == ':') begin_program();
    if (rest.front() == 'N') note_label(rest, number);
    if (text.find("PRNT") != std::string::npos) return;
    if (const auto target = number_behind(text, "GOTO")) jump(*target, number);
    if (const auto end = number_behind(text, "END")) {
      close(*end, number);
    } else if (const auto begin = number_behind(text, "DO")) {
      open_.emplace_back(*begin, number);
    }
  }

  [[nodiscard]] FileMarks done() { return std::move(marks_); }

 private:
  void begin_program() {
    open_.clear();
    labels_.clear();
  }

  void note_label(std::string_view rest, std::uint32_t number) {
    if (const auto label =
            number_behind(rest.substr(0, rest.find_first_not_of("N0123456789")), "N"))
      add_label(*label, number);
  }

  void add_label(std::uint64_t label, std::uint32_t number) {
    labels_.emplace(label, number);
    marks_.labels.push_back({label, number});
  }

  void jump(std::uint64_t target, std::uint32_t number) {
    const auto label = labels_.find(target);
    if (label != labels_.end()) marks_.loops.push_back({label->second, number});
  }

  void close(std::uint64_t slot, std::uint32_t number) {
    while (!open_.empty() && open_.back().first != slot) open_.pop_back();
    if (open_.empty()) return;
    marks_.loops.push_back({open_.back().second, number});
    open_.pop_back();
  }

  FileMarks marks_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> open_;  // number of the DO, its line
  std::map<std::uint64_t, std::uint32_t> labels_;              // N words so far, their lines
};

}  // namespace

FileMarks marks_in(const base::SourceFile& file) {
  if (file.size() > kLargestFile) return {};
  std::string text(static_cast<std::size_t>(file.size()), '\0');
  text.resize(file.read(0, text));
  MarkReader reader;
  std::uint32_t number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    reader.take(std::string_view(text).substr(begin, end - begin), number);
    begin = end + 1;
  }
  return reader.done();
}

std::uint32_t line_of(const FileMarks& marks, std::uint64_t number, std::uint32_t behind) {
  std::uint32_t first = 0;
  for (const FileMarks::Label& label : marks.labels) {
    if (label.number != number) continue;
    if (label.line > behind) return label.line;
    if (first == 0) first = label.line;
  }
  return first;
}

std::optional<LineSpan> innermost(const FileMarks& marks, LineSpan lines) {
  std::optional<LineSpan> best;
  for (const LineSpan& loop : marks.loops) {
    if (loop.first > lines.first || loop.last < lines.last) continue;
    if (!best || loop.last - loop.first < best->last - best->first) best = loop;
  }
  return best;
}

}  // namespace kerf::features
