#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lang/basic/page.hpp"

namespace kerf::control {

/// Makes the text that PRINT puts out (docs/laser-basic.md, Statements): numbers with ten digits, a
/// comma goes to the next multiple of eight columns, a semicolon is one blank. Remembers the
/// column.
class LaserPrint {
 public:
  /// What these items of the page print; numbers come from the registers. Valid until the next
  /// call.
  [[nodiscard]] std::string_view text_of(const basic::BasicPage& page,
                                         std::span<const basic::PrintItem> items,
                                         const double* registers);
  void reset() { column_ = 0; }

 private:
  void add(std::string_view text);
  void add_number(double value);
  void go_to_next_column();

  std::string text_;
  std::size_t column_ = 0;
};

}  // namespace kerf::control
