#pragma once

#include <numbers>

#include "geometry/vec2.hpp"

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

/// Heading of a move whose points are one: no direction has this value.
inline constexpr double kNoHeading_deg = 360;

/// Direction from `from` to `to` in degrees, counterclockwise from the first axis: in
/// [0, 360 - 1e-6), so that six decimals never print 360, or kNoHeading_deg when the points are one
/// (kSamePoint_mm). Of an arc it is the chord's: a full circle has none although the tool moves.
[[nodiscard]] double heading_deg(Vec2 from, Vec2 to);

}  // namespace kerf::geometry
