#pragma once

#include <cstdint>

#include "lang/gcode/keywords.hpp"
#include "lang/vm/builtin.hpp"

namespace kerf::gcode {

/// Functions and operators of Custom Macro B that are not instructions of the virtual machine.
enum class Function : std::uint32_t {
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2,
  sqrt,
  abs,
  bin,
  bcd,
  round,
  round_to,  ///< (value, increment): ROUND inside an address word (EXP-12)
  fix,
  fup,
  ln,
  exp,
  pow,
  adp,
  mod,
  and_,
  or_,
  xor_,
  label,      ///< checks and rounds the operand of GOTO (CTL-1)
  parameter,  ///< (number, suffix): the variable number of PRM
};

/// The table that vm::CodePage::builtins points to; its context's rules are a MathRules.
[[nodiscard]] const vm::Builtin* builtin_table();

[[nodiscard]] inline std::uint32_t number_of(Function function) {
  return static_cast<std::uint32_t>(function);
}

}  // namespace kerf::gcode
