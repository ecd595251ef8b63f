#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "control/core/alarms.hpp"
#include "control/gcode/words/words.hpp"
#include "lang/gcode/page.hpp"

namespace kerf::control {

/// Values for #1 to #33 of a macro level; index 0 stays null.
using LocalVariables = std::array<double, gcode::kLocals>;

/// How the words of a call become local variables.
struct ArgumentRules {
  bool inch = false;
  bool calculator_point = false;
  bool single_ijk = false;   ///< IJK: I, J, K are always #4, #5, #6
  bool every_block = false;  ///< G66.1: G, L, P and N are arguments as well (CALL-21)
};

/// A program call as its block writes it.
struct CallWords {
  const gcode::Word* program = nullptr;  ///< P
  const gcode::Word* repeats = nullptr;  ///< L
  LocalVariables locals{};
};

/// Argument specifications I and II together (docs/dialect.md §6.2, ARG-1 to ARG-6): letters have
/// their variable; I, J, K begin a new set of three whenever they do not ascend. The later of two
/// words for the same variable counts. False: an alarm was raised.
[[nodiscard]] bool read_arguments(std::span<const gcode::Word> words, const ArgumentRules& rules,
                                  Alarms& alarms, CallWords& call);

}  // namespace kerf::control
