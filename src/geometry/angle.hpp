#pragma once

#include <numbers>

namespace kerf::geometry {

constexpr double degrees(double angle_rad) { return angle_rad * (180 / std::numbers::pi); }
constexpr double radians(double angle_deg) { return angle_deg * (std::numbers::pi / 180); }

/// Sine and cosine of an angle in degrees, exact at multiples of 90.
struct SineCosine {
  double sine = 0;
  double cosine = 1;
};
[[nodiscard]] SineCosine sine_cosine_deg(double angle_deg);

/// `angle_deg` plus the multiple of `turn_deg` > 0 that brings it nearest to `previous_deg`: the
/// difference to it lies in [-turn/2, turn/2).
[[nodiscard]] double nearest_turn(double angle_deg, double previous_deg, double turn_deg = 360);

}  // namespace kerf::geometry
