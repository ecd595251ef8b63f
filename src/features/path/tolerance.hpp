#pragma once

namespace kerf::features {

// The tolerances of recognition, mm and mm².
inline constexpr double kSamePoint_mm = 1e-3;
// What words of three digits, of inches four, make of one place: of a middle by its arcs.
inline constexpr double kRounded_mm = 5e-3;
inline constexpr double kSameZ_mm = 1e-4;
inline constexpr double kEmptyArea_mm2 = 1e-3;

}  // namespace kerf::features
