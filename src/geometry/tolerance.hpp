#pragma once

namespace kerf::geometry {

/// Points that are no farther from each other are one.
inline constexpr double kSamePoint_mm = 1e-6;

}  // namespace kerf::geometry
