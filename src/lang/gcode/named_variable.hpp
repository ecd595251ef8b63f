#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lang/gcode/lexer.hpp"
#include "lang/gcode/name_table.hpp"
#include "lang/gcode/operand.hpp"

namespace kerf::gcode {

/// Reads variables that are written by name: "[#NAME]", "[#_NAME[n]]" (docs/dialect.md §2).
class NamedVariable {
 public:
  /// Both must outlive this.
  NamedVariable(Cursor& cursor, NameTable& names) : cursor_(cursor), names_(names) {}

  /// Standing on a bracket: a name begins there.
  [[nodiscard]] bool is_next() const;
  /// Throws SyntaxError.
  [[nodiscard]] Variable read();

 private:
  std::uint32_t system_variable(const std::string& name, const char* begin);
  [[noreturn]] void fail(base::Code code, std::string_view detail = {}) const;
  [[noreturn]] void fail_since(base::Code code, const char* begin) const;

  Cursor& cursor_;
  NameTable& names_;
};

}  // namespace kerf::gcode
