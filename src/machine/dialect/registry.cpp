#include "machine/dialect/registry.hpp"

#include <algorithm>
#include <array>

#include "control/gcode/codes/lathe_codes.hpp"
#include "drive/pattern/language.hpp"
#include "lang/basic/language.hpp"
#include "lang/gcode/language.hpp"
#include "lang/records/language.hpp"
#include "lang/teach/language.hpp"

namespace kerf::machine {
namespace {

using Kind = DialectRow::Kind;

// So much of a text is looked at.
constexpr std::size_t kBytesToShow = 4096;

const control::CodeTable& codes_of_mills(const control::Parameters& /*parameters*/) {
  return control::mill_codes();
}

const control::CodeTable& codes_of_lathes(const control::Parameters& parameters) {
  return control::lathe_codes(parameters.g_system);
}

template <typename Is>
const DialectRow* first_dialect(const Is& is) {
  const auto rows = dialects();
  const auto found = std::find_if(rows.begin(), rows.end(), is);
  return found == rows.end() ? nullptr : &*found;
}

const DialectRow* dialect_by_word(const base::FirstWord& first) {
  return first_dialect([&](const DialectRow& row) {
    return row.language->shows_by_word != nullptr && row.language->shows_by_word(first);
  });
}

// A line that may be of any language: none behind it is looked at.
bool says_something(const base::FirstWord& first) {
  return first.next == '%' || first.next == '(' || !first.word.empty();
}

}  // namespace

std::span<const DialectRow> dialects() {
  static const std::array rows = {
      DialectRow{Kind::gcode, "fanuc-mill", &gcode::language(), "mill3", codes_of_mills},
      DialectRow{Kind::gcode, kLatheDialect, &gcode::language(), "lathe2", codes_of_lathes},
      DialectRow{Kind::basic, "laser-basic", &basic::language(), "laser3"},
      DialectRow{Kind::teach, "teach", &teach::language(), "laser5"},
      DialectRow{Kind::motion, kMotionDialect, &records::language(), "mill3"},
      DialectRow{Kind::pattern, kPatternDialect, &drive::pattern_language(), "arm4"}};
  return rows;
}

std::vector<std::string_view> dialect_names() {
  std::vector<std::string_view> names;
  for (const DialectRow& row : dialects()) names.push_back(row.name);
  return names;
}

std::vector<std::string_view> text_dialects() {
  std::vector<std::string_view> names;
  for (const DialectRow& row : dialects()) {
    if (!row.language->is_listing) names.push_back(row.name);
  }
  return names;
}

const DialectRow* find_dialect(std::string_view name) {
  return first_dialect([&](const DialectRow& row) { return row.name == name; });
}

const DialectRow* dialect_by_ending(const std::string& path) {
  return first_dialect(
      [&](const DialectRow& row) { return base::shows_by_ending(*row.language, path); });
}

const DialectRow* dialect_by_text(const base::SourceFile& program) {
  std::string text(std::min<std::uint64_t>(kBytesToShow, program.size()), '\0');
  text.resize(program.read(0, text));
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    const auto first = base::FirstWord::of(std::string_view(text).substr(begin, end - begin));
    if (const DialectRow* const row = dialect_by_word(first)) return row;
    if (says_something(first)) return nullptr;
    begin = end + 1;
  }
  return nullptr;
}

std::string dialect_shown_by(const base::SourceFile& program) {
  const DialectRow* row = dialect_by_ending(program.name());
  if (row == nullptr) row = dialect_by_text(program);
  return row == nullptr ? std::string() : std::string(row->name);
}

bool ends_as_pattern(const std::string& path) {
  const DialectRow* const row = dialect_by_ending(path);
  return row != nullptr && row->kind == Kind::pattern;
}

}  // namespace kerf::machine
