#pragma once

#include <cstdint>

#include "lang/gcode/emitter.hpp"

namespace kerf::gcode {

/// The result of a part of an expression: a constant or a register, a number or a truth value.
struct Operand {
  bool is_constant = false;
  bool is_truth = false;
  double value = 0;             ///< of a constant
  std::uint8_t reg = 0;         ///< otherwise
  const char* begin = nullptr;  ///< the text that it was made from
  const char* end = nullptr;
};

/// A variable as it stands on the left of '=' or as an operand.
struct Variable {
  enum class Kind : std::uint8_t { local, global, fixed, computed } kind = Kind::fixed;
  std::uint32_t number = 0;  ///< register, global or host's number
  std::uint8_t reg = 0;      ///< computed: holds the number
  const char* begin = nullptr;
  const char* end = nullptr;
};

/// The register that holds the operand; a constant is loaded into a new one.
[[nodiscard]] std::uint8_t in_register(Emitter& emitter, const Operand& operand);
/// Where the result of both goes: into one of their temporaries, or a new one.
[[nodiscard]] std::uint8_t result_register(Emitter& emitter, const Operand& left,
                                           const Operand& right);
[[nodiscard]] Operand load_variable(Emitter& emitter, const Variable& variable);
/// Emits `variable = operand`.
void store_variable(Emitter& emitter, const Variable& variable, const Operand& operand);

}  // namespace kerf::gcode
