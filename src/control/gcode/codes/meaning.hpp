#pragma once

#include <cstdint>

namespace kerf::control {

// The tables of codes say what there is: each row G or M adds an enumerator of its name, so a name
// has one such row in all tables together. Rows ALSO_G and ALSO_M give a further number, of this
// dialect or of another one, to what has such a row. The order of the enumerators means nothing.

/// What a G code means, whatever number it has in a dialect.
enum class Meaning : std::uint8_t {
  none,
#define G(number, meaning, ...) meaning,
#define ALSO_G(...)
#define M(...)
#define ALSO_M(...)
#include "control/gcode/codes/mill_codes.def"
#undef G
#define G(a, b, c, meaning, ...) meaning,
#include "control/gcode/codes/lathe_codes.def"
#undef G
#undef ALSO_G
#undef M
#undef ALSO_M
};

/// What an M code means.
enum class Function : std::uint8_t {
  passed_on,  ///< nothing to the control
#define G(...)
#define ALSO_G(...)
#define M(number, function, ...) function,
#define ALSO_M(...)
#include "control/gcode/codes/lathe_codes.def"
#include "control/gcode/codes/mill_codes.def"
#undef G
#undef ALSO_G
#undef M
#undef ALSO_M
};

/// Whether an M code calls a program or returns from one.
[[nodiscard]] constexpr bool is_call(Function function) {
  return function == Function::call || function == Function::return_ ||
         function == Function::external_call;
}

}  // namespace kerf::control
