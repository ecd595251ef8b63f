#include "output/programs/internal/round_way.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/decimal.hpp"
#include "geometry/arc.hpp"
#include "math/math.hpp"

namespace kerf::output {

RoundWay::RoundWay(const motion::PlaneAxes& axes, const base::TipPoint& begin,
                   const motion::Arc& arc)
    : plane(axes),
      from(begin),
      to(arc.to),
      centre{arc.center[0], arc.center[1]},
      radius(length(axes.project(begin) - centre)),
      end_radius(length(axes.project(arc.to) - centre)) {
  const bool clockwise = arc.direction == motion::Direction::clockwise;
  const geometry::Vec2 first = plane.project(from);
  start_rad = math::atan2(first.v - centre.v, first.u - centre.u);
  sweep_rad = geometry::sweep_rad(first, plane.project(to), centre, clockwise) +
              2 * std::numbers::pi * arc.turns;
  sign = clockwise ? -1 : 1;
}

base::TipPoint RoundWay::at(double share) const {
  if (share <= 0) return from;
  if (share >= 1) return to;
  base::TipPoint point = from;
  for (std::size_t i = 0; i < base::kMaxAxes; ++i)
    point.values[i] = base::tidy(from.values[i] + share * (to.values[i] - from.values[i]));
  const double angle = start_rad + sign * share * sweep_rad;
  const double r = radius + share * (end_radius - radius);
  const auto [sine, cosine] = math::sine_cosine(angle);
  plane.place(point, {base::tidy(centre.u + r * cosine), base::tidy(centre.v + r * sine)});
  return point;
}

double RoundWay::chord_count(double tolerance_mm) const {
  const double most_rad = geometry::chord_angle_rad(std::max(radius, end_radius), tolerance_mm);
  return std::max(1.0, std::ceil(sweep_rad / most_rad - 1e-9));
}

}  // namespace kerf::output
