#include "process/job_texts.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "base/decimal.hpp"
#include "base/output_file.hpp"
#include "base/source_file.hpp"
#include "process/internal/nearest_name.hpp"

namespace kerf::process {
namespace {

constexpr std::string_view kSerial = "serial";
constexpr std::size_t kLongestKept = 40;  // bytes of the file

/// The stretches of a text: as they are, or the name between braces.
class WordsReader {
 public:
  struct Part {
    std::string_view text;
    bool is_name = false;
  };

  explicit WordsReader(std::string_view words) : rest_(words) {}

  /// False at the end, and where a brace is not closed.
  bool next(Part& part) {
    if (rest_.empty()) return false;
    if (rest_.starts_with("{{")) {
      part = {rest_.substr(0, 1), false};
      rest_.remove_prefix(2);
    } else if (rest_.front() == '{') {
      return take_name(part);
    } else {
      part = {rest_.substr(0, rest_.find('{')), false};
      rest_.remove_prefix(part.text.size());
    }
    return true;
  }
  [[nodiscard]] bool is_open() const { return !rest_.empty(); }

 private:
  bool take_name(Part& part) {
    const std::size_t end = rest_.find('}');
    if (end == std::string_view::npos) return false;
    part = {rest_.substr(1, end - 1), true};
    rest_.remove_prefix(end + 1);
    return true;
  }

  std::string_view rest_;
};

tl::unexpected<base::Diagnostic> wrong_text(const base::Place& place, std::string_view words,
                                            const std::string& what, const std::string& hint = {}) {
  return tl::unexpected(
      make_error(base::Code::job_text, place, '"' + shown(words) + "\" " + what, hint));
}

std::string hint_for(std::string_view name, const TextVariables& variables) {
  std::vector<std::string_view> names{kSerial};
  for (const auto& [each, value] : variables) names.push_back(each);
  return nearest_hint(name, names);
}

tl::unexpected<base::Failure> no_serial(const std::string& path) {
  return tl::unexpected(base::Failure{
      base::Failure::Kind::input,
      path + ": holds no serial number; a file of text.serial.keep has one number from 0 to " +
          std::to_string(Serials::kMost)});
}

}  // namespace

std::string Serials::text(std::uint64_t copy) const {
  const std::string digits = std::to_string(behind(copy));
  const std::size_t missing = width_ > digits.size() ? width_ - digits.size() : 0;
  return std::string(missing, '0') + digits;
}

base::Outcome<std::uint64_t> kept_serial(const std::string& path, std::uint64_t otherwise) {
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown) && !unknown) return otherwise;
  const auto file = base::SourceFile::open(path, {.most_bytes = kLongestKept + 1});
  if (!file) return tl::unexpected(file.error());
  std::string text = (*file)->line_at(0, kLongestKept);
  if (text.ends_with('\r')) text.pop_back();
  const auto number = base::read_whole_number(text);
  if ((*file)->size() > kLongestKept || !number || *number > Serials::kMost) return no_serial(path);
  return *number;
}

base::Outcome<void> keep_serial(const std::string& path, std::uint64_t next) {
  auto file = base::OutputFile::create(path);
  if (!file) return tl::unexpected(file.error());
  (*file)->write(std::to_string(next) + "\n");
  return (*file)->commit();
}

base::Result<std::string> filled_words(std::string_view words, const TextVariables& variables,
                                       const base::Place& place) {
  std::string filled;
  WordsReader reader{words};
  WordsReader::Part part;
  while (reader.next(part)) {
    if (!part.is_name) {
      filled += part.text;
      continue;
    }
    const auto found = variables.find(std::string(part.text));
    if (found == variables.end()) {
      return wrong_text(place, words,
                        "names " + shown(part.text) + ", to which nothing gives a value",
                        hint_for(part.text, variables));
    }
    filled += found->second;
  }
  if (reader.is_open()) return wrong_text(place, words, "has a brace that is not closed");
  return filled;
}

bool names_serial(std::string_view words) {
  WordsReader reader{words};
  WordsReader::Part part;
  bool is_named = false;
  while (reader.next(part)) is_named = is_named || (part.is_name && part.text == kSerial);
  return is_named;
}

}  // namespace kerf::process
