#pragma once

#include "lang/basic/keywords.hpp"
#include "lang/vm/builtin.hpp"

namespace kerf::basic {

/// Functions and operators that are not instructions of the virtual machine. Angles are radians.
enum class Function : std::uint32_t {
  sin,
  cos,
  tan,
  atn,
  asin,
  acos,
  sqr,
  abs,
  int_,
  sgn,
  exp,
  log,
  atan2,
  min,
  max,
  mod,
  distance,   ///< between (x, y, z) and (x, y, z)
  remainder,  ///< of "%"
  power,      ///< of "^"
  and_,
  or_,
};

/// The table that vm::CodePage::builtins points to.
[[nodiscard]] const vm::Builtin* builtin_table();

[[nodiscard]] inline std::uint32_t number_of(Function function) {
  return static_cast<std::uint32_t>(function);
}

}  // namespace kerf::basic
