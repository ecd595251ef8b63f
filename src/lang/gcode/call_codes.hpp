#pragma once

namespace kerf::gcode {

// The G codes of the macro language, which the language itself defines: what stands behind the
// first three are arguments, and their letters mean no axes.
inline constexpr double kMacroCall = 65;
inline constexpr double kModalCall = 66;
inline constexpr double kModalCallEveryBlock = 66.1;
inline constexpr double kModalCallOff = 67;

}  // namespace kerf::gcode
