#pragma once

#include <optional>

#include "geometry/vec2.hpp"

namespace kerf::geometry {

/// A line without ends as drawings give it: through a point, at an angle from the first axis,
/// degrees, counterclockwise. An angle and the angle plus 180 are the same line.
struct AngledLine {
  Vec2 through;
  double angle_deg = 0;
};

/// Lines and axes that differ by less do not meet: less than the least angle that a program can
/// write, 0.001 degrees.
inline constexpr double kParallel_rad = 1e-5;

// Accuracy: with both points of size <= s and an angle of a >= 0.01 rad between the lines, the
// result is nearer than 1e-9 s to the exact one.

/// The point of the line whose first coordinate is `u`. Nothing: the line runs along the second
/// axis.
[[nodiscard]] std::optional<Vec2> point_at_u(const AngledLine& line, double u);
/// The point of the line whose second coordinate is `v`. Nothing: the line runs along the first
/// axis.
[[nodiscard]] std::optional<Vec2> point_at_v(const AngledLine& line, double v);
/// Where two lines cross. Nothing: they are parallel.
[[nodiscard]] std::optional<Vec2> crossing(const AngledLine& a, const AngledLine& b);
/// Distance of a point from the line, >= 0.
[[nodiscard]] double distance(const AngledLine& line, Vec2 point);

}  // namespace kerf::geometry
