#include "geometry/intersect.hpp"

#include <algorithm>

namespace kerf::geometry {
namespace {

Intersections lines(const Curve& a, const Curve& b) {
  const double denominator = cross(a.direction, b.direction);
  if (std::fabs(denominator) <= 1e-12 * length(a.direction) * length(b.direction)) return {};
  const double t = cross(b.point - a.point, b.direction) / denominator;
  return {{a.point + t * a.direction}, 1};
}

// The points at distance `along` ± half from `foot` on a line of unit `direction`.
Intersections pair(Vec2 foot, Vec2 direction, double square, double tolerance, double radius) {
  if (square < 0) {
    if (square < -2 * radius * tolerance) return {};
    return {{foot}, 1};
  }
  const double half = std::sqrt(square);
  return {{foot - half * direction, foot + half * direction}, 2};
}

Intersections line_circle(const Curve& line, const Curve& circle, double tolerance) {
  const Vec2 direction = unit(line.direction);
  const Vec2 foot = line.point + dot(circle.point - line.point, direction) * direction;
  const double distance = length(foot - circle.point);
  return pair(foot, direction, circle.radius * circle.radius - distance * distance, tolerance,
              std::max(circle.radius, distance));
}

Intersections circles(const Curve& a, const Curve& b, double tolerance) {
  const Vec2 between = b.point - a.point;
  const double d = length(between);
  if (d <= 1e-12 * std::max(a.radius, b.radius) || d == 0) return {};
  const Vec2 direction = unit(between);
  const double along = (d * d + a.radius * a.radius - b.radius * b.radius) / (2 * d);
  const double square = a.radius * a.radius - along * along;
  return pair(a.point + along * direction, left_of(direction), square, tolerance,
              std::max(a.radius, std::fabs(along)));
}

}  // namespace

Intersections intersect(const Curve& a, const Curve& b, double tolerance) {
  if (!a.is_circle && !b.is_circle) return lines(a, b);
  if (!a.is_circle) return line_circle(a, b, tolerance);
  if (!b.is_circle) return line_circle(b, a, tolerance);
  return circles(a, b, tolerance);
}

}  // namespace kerf::geometry
