#include "geometry/arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/math.hpp"

namespace kerf::geometry {

std::optional<Vec2> centre_from_radius(Vec2 from, Vec2 to, double radius, bool clockwise,
                                       double tolerance) {
  const Vec2 chord = to - from;
  const double d = length(chord);
  const double r = std::fabs(radius);
  if (d > 2 * (r + tolerance)) return std::nullopt;
  const Vec2 middle = 0.5 * (from + to);
  const double h = std::sqrt(std::max(0.0, r * r - d * d / 4));
  const double side = (radius > 0) != clockwise ? 1 : -1;
  return middle + (side * h / d) * left_of(chord);
}

double sweep_rad(Vec2 from, Vec2 to, Vec2 centre, bool clockwise) {
  constexpr double kFull = 2 * std::numbers::pi;
  if (from == to) return kFull;
  const Vec2 a = from - centre;
  const Vec2 b = to - centre;
  double angle = math::atan2(cross(a, b), dot(a, b));
  if (clockwise) angle = -angle;
  return angle <= 0 ? angle + kFull : angle;
}

double arc_length(Vec2 from, Vec2 to, Vec2 centre, bool clockwise, unsigned extra_turns,
                  double rise) {
  const double sweep = sweep_rad(from, to, centre, clockwise) + 2 * std::numbers::pi * extra_turns;
  const double mean_radius = (length(from - centre) + length(to - centre)) / 2;
  return math::hypot(sweep * mean_radius, rise);
}

// deviation = R (1 - cos (angle / 2)) = 2 R sin² (angle / 4)
double chord_angle_rad(double radius, double deviation) {
  if (radius <= deviation) return std::numbers::pi;
  return 4 * math::asin(std::sqrt(deviation / (2 * radius)));
}

}  // namespace kerf::geometry
