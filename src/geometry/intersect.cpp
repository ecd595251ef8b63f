#include "geometry/intersect.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::geometry {
namespace {

Intersections lines(const Curve& a, const Curve& b) {
  const double denominator = cross(a.direction, b.direction);
  if (std::fabs(denominator) <= 1e-12 * length(a.direction) * length(b.direction)) return {};
  const double t = cross(b.point - a.point, b.direction) / denominator;
  return {{a.point + t * a.direction}, 1};
}

// The two points at the distance √`square` from `foot` on a line of unit `direction`.
Intersections pair(Vec2 foot, Vec2 direction, double square) {
  const double half = std::sqrt(square);
  return {{foot - half * direction, foot + half * direction}, 2};
}

// Curves that come no nearer to each other than `gap` (which rounding may make negative).
Intersections touch(Vec2 point, double gap, double tolerance) {
  if (gap > tolerance) return {};
  return {{point}, 1};
}

Intersections line_circle(const Curve& line, const Curve& circle, double tolerance) {
  const Vec2 direction = unit(line.direction);
  const Vec2 foot = line.point + dot(circle.point - line.point, direction) * direction;
  const double distance = length(foot - circle.point);
  const double square = circle.radius * circle.radius - distance * distance;
  if (square >= 0) return pair(foot, direction, square);
  return touch(foot, distance - circle.radius, tolerance);
}

// Circles beside each other, or one inside of the other: they touch in the middle of the gap.
// `direction` leads from the centre of `a` to that of `b`, at the distance `d`.
Intersections touch_circles(const Curve& a, const Curve& b, Vec2 direction, double d,
                            double tolerance) {
  const double beside = d - a.radius - b.radius;
  if (beside > -std::min(a.radius, b.radius))
    return touch(a.point + (a.radius + beside / 2) * direction, beside, tolerance);
  const double inside = std::fabs(a.radius - b.radius) - d;
  const double from_a = a.radius > b.radius ? a.radius - inside / 2 : -a.radius - inside / 2;
  return touch(a.point + from_a * direction, inside, tolerance);
}

Intersections circles(const Curve& a, const Curve& b, double tolerance) {
  const Vec2 between = b.point - a.point;
  const double d = length(between);
  if (d <= 1e-12 * std::max(a.radius, b.radius) || d == 0) return {};
  const Vec2 direction = unit(between);
  const double along = (d * d + a.radius * a.radius - b.radius * b.radius) / (2 * d);
  const double square = a.radius * a.radius - along * along;
  if (square >= 0) return pair(a.point + along * direction, left_of(direction), square);
  return touch_circles(a, b, direction, d, tolerance);
}

}  // namespace

Intersections intersect(const Curve& a, const Curve& b, double tolerance) {
  if (!a.is_circle && !b.is_circle) return lines(a, b);
  if (!a.is_circle) return line_circle(a, b, tolerance);
  if (!b.is_circle) return line_circle(b, a, tolerance);
  return circles(a, b, tolerance);
}

}  // namespace kerf::geometry
