#pragma once

#include <numbers>

namespace kerf::stock {

[[nodiscard]] constexpr double radians(double degrees) { return degrees / 180 * std::numbers::pi; }

/// What is written with the digits of a double, and read again, is as long.
inline constexpr double kAlmost_mm = 1e-9;

}  // namespace kerf::stock
