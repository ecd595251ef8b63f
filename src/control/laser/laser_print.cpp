#include "control/laser/laser_print.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lang/vm/value.hpp"

namespace kerf::control {
namespace {

constexpr std::size_t kColumns = 8;

}  // namespace

std::string_view LaserPrint::text_of(const basic::BasicPage& page,
                                     std::span<const basic::PrintItem> items,
                                     const double* registers) {
  using Kind = basic::PrintItem::Kind;
  text_.clear();
  for (const basic::PrintItem& item : items) {
    switch (item.kind) {
      case Kind::number: add_number(vm::zero_if_null(registers[item.register_])); break;
      case Kind::text: add(page.texts[item.text]); break;
      case Kind::comma: go_to_next_column(); break;
      case Kind::semicolon: add(" "); break;
      case Kind::new_line:
        text_ += '\n';
        column_ = 0;
        break;
    }
  }
  return text_;
}

// Columns are characters of UTF-8.
void LaserPrint::add(std::string_view text) {
  text_ += text;
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  column_ += static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins));
}

void LaserPrint::add_number(double value) { add(fmt::format("{:.10g}", value + 0.0)); }

// At least one blank.
void LaserPrint::go_to_next_column() { add(std::string(kColumns - column_ % kColumns, ' ')); }

}  // namespace kerf::control
