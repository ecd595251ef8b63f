#include "output/writing/diagnostic_text.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/program_name.hpp"

namespace kerf::output {
namespace {

constexpr std::size_t kWidth = 120;  // of the source text that is shown
constexpr std::size_t kReach =
    4 * kWidth;  // bytes of it on either side: a character has up to four

// Bytes of a valid UTF-8 character at `at`, or 0; 0 as well for the control characters U+0080 to
// U+009F.
std::size_t character_length(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xc2 && first < 0xe0 ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                             : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0) != 0x80) return 0;
  }
  const bool overlong =
      (first == 0xe0 && byte(at + 1) < 0xa0) || (first == 0xf0 && byte(at + 1) < 0x90);
  const bool control = first == 0xc2 && byte(at + 1) < 0xa0;
  const bool surrogate = first == 0xed && byte(at + 1) >= 0xa0;
  const bool too_high = first == 0xf4 && byte(at + 1) >= 0x90;
  return overlong || control || surrogate || too_high ? 0 : length;
}

// A file name keeps its bytes, so that it can be opened; only control characters may not be
// printed.
std::string one_line(std::string name) {
  std::replace_if(
      name.begin(), name.end(),
      [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, '?');
  return name;
}

struct Column {
  std::string text;  // what stands there
  std::size_t byte;  // where it begins in the source line
};

std::vector<Column> columns_of(const std::string& line) {
  std::vector<Column> columns;
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t length = character_length(line, i);
    const auto c = static_cast<unsigned char>(line[i]);
    if (length == 0) {
      columns.push_back({"?", i++});
    } else if (length == 1) {
      columns.push_back({c == '\t'              ? " "
                         : c < ' ' || c == 0x7f ? "?"
                                                : std::string(1, line[i]),
                         i});
      ++i;
    } else {
      columns.push_back({line.substr(i, length), i});
      i += length;
    }
  }
  return columns;
}

// The source line with a caret below, at most kWidth columns of it around the caret.
std::string excerpt(const base::Place& place, const base::SourceFile& file) {
  const std::size_t column = place.column > 0 ? place.column - 1 : 0;
  const std::size_t skipped = column > kReach ? column - kReach : 0;
  const std::string line = file.line_at(place.line_start + skipped, 2 * kReach);
  const std::vector<Column> columns = columns_of(line);
  const auto index_of = [&](std::size_t byte) {
    return static_cast<std::size_t>(std::count_if(columns.begin(), columns.end(),
                                                  [&](const Column& c) { return c.byte < byte; }));
  };
  const std::size_t first = index_of(column - skipped);
  const std::size_t last = std::max(first + 1, index_of(column - skipped + place.length));
  const std::size_t begin = first > kWidth / 2 ? first - kWidth / 2 : 0;
  const std::size_t end = std::min(columns.size(), begin + kWidth);
  std::string text = begin > 0 ? "…" : "";
  for (std::size_t i = begin; i < end; ++i) text += columns[i].text;
  if (end < columns.size()) text += "…";
  std::string caret(first - begin + (begin > 0 ? 1 : 0), ' ');
  caret += '^';
  caret.append(std::min(last, std::max(end, first + 1)) - first - 1, '~');
  return "    " + text + "\n    " + caret + "\n";
}

}  // namespace

const char* severity_name(base::Severity severity) {
  switch (severity) {
    case base::Severity::error: return "error";
    case base::Severity::warning: return "warning";
    case base::Severity::note: return "note";
  }
  return "";
}

std::string printable(const std::string& text) {
  std::string result;
  for (const Column& column : columns_of(text)) result += column.text;
  return result;
}

std::string file_name(const base::Diagnostic& diagnostic, const base::SourceSet& sources) {
  return sources.contains(diagnostic.place.file) ? sources[diagnostic.place.file].name()
                                                 : std::string();
}

std::string diagnostic_text(const base::Diagnostic& diagnostic, const base::SourceSet& sources) {
  std::string text;
  const std::string file = file_name(diagnostic, sources);
  if (!file.empty()) text += one_line(file) + ":";
  if (diagnostic.place.line > 0) {
    text +=
        std::to_string(diagnostic.place.line) + ":" + std::to_string(diagnostic.place.column) + ":";
  }
  if (diagnostic.offset) text += "byte " + std::to_string(*diagnostic.offset) + ":";
  text += std::string(text.empty() ? "" : " ") + severity_name(diagnostic.severity) + ": " +
          diagnostic.number + " " + printable(diagnostic.message);
  if (!diagnostic.program.empty() && diagnostic.program != base::kUnnumberedProgram)
    text += " (" + printable(diagnostic.program) + ")";
  text += "\n";
  if (!file.empty() && diagnostic.place.line > 0)
    text += excerpt(diagnostic.place, sources[diagnostic.place.file]);
  if (!diagnostic.hint.empty()) text += "    hint: " + printable(diagnostic.hint) + "\n";
  return text;
}

std::string diagnostic_json(const base::Diagnostic& diagnostic, const base::SourceSet& sources) {
  nlohmann::ordered_json object;
  object["severity"] = severity_name(diagnostic.severity);
  object["code"] = diagnostic.number;
  object["message"] = printable(diagnostic.message);
  object["file"] = file_name(diagnostic, sources);
  object["line"] = diagnostic.place.line;
  object["column"] = diagnostic.place.column;
  object["program"] = printable(diagnostic.program);
  object["hint"] = diagnostic.hint;
  if (diagnostic.offset) object["offset"] = *diagnostic.offset;
  return object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace kerf::output
