#include "motion/turning_rapid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angle.hpp"
#include "math/math.hpp"

namespace kerf::motion {
namespace {

using base::AxisVector;
using base::TipPoint;
using geometry::Vec2;

// Where a tip is over the work.
Vec2 over_work(const AxisSetup& axes, const TipPoint& tip) {
  return {tip[*axes.find('X')], tip[*axes.find('Y')]};
}

double radius_of(Vec2 place) { return math::hypot(place.u, place.v); }

// How far the work turns, in [-π, π); 0 where an end has no angle.
double turn_between(Vec2 from, Vec2 to) {
  if (std::min(radius_of(from), radius_of(to)) < TurningRapid::kOnAxis_mm) return 0;
  const double turn = math::atan2(geometry::cross(from, to), geometry::dot(from, to));
  return turn == std::numbers::pi ? -turn : turn;
}

bool is_over_work(const AxisConfig& axis) { return axis.letter == 'X' || axis.letter == 'Y'; }

}  // namespace

std::optional<TurningRapid> TurningRapid::between(const AxisSetup& axes, const TipPoint& from,
                                                  const TipPoint& to) {
  const Vec2 begin = over_work(axes, from);
  const Vec2 end = over_work(axes, to);
  TurningRapid way;
  way.turn_rad_ = turn_between(begin, end);
  if (way.turn_rad_ == 0) return std::nullopt;
  way.axes_ = &axes;
  way.from_ = from;
  way.to_ = to;
  way.begin_radius_mm_ = radius_of(begin);
  way.radius_change_mm_ = radius_of(end) - way.begin_radius_mm_;
  way.begin_rad_ = math::atan2(begin.v, begin.u);
  return way;
}

double TurningRapid::seconds(const AxisSetup& axes, const TipPoint& from, const TipPoint& to) {
  const Vec2 begin = over_work(axes, from);
  const Vec2 end = over_work(axes, to);
  const double out_mm = std::fabs(radius_of(end) - radius_of(begin));
  const double turn_deg = std::fabs(geometry::degrees(turn_between(begin, end)));
  double minutes = std::max(out_mm / axes.turning_work->radius_per_min,
                            turn_deg / axes.turning_work->angle_per_min);
  for (std::size_t m = 0; m < axes.count(); ++m) {
    if (is_over_work(axes.axes[m])) continue;
    const double way = std::fabs(to.values[m] - from.values[m]);
    minutes = std::max(minutes, way / axes.axes[m].rapid_per_min);
  }
  return 60 * minutes;
}

Curve TurningRapid::curve() const {
  const double mean_radius = begin_radius_mm_ + radius_change_mm_ / 2;
  const double length = math::hypot(mean_radius * turn_rad_, radius_change_mm_);
  ArcShape shape;
  shape.origin = from_;
  for (std::size_t m = 0; m < axes_->count(); ++m) {
    if (is_over_work(axes_->axes[m])) {
      shape.origin.values[m] = 0;
    } else {
      shape.slope.values[m] = (to_.values[m] - from_.values[m]) / length;
    }
  }
  shape.e1[*axes_->find('X')] = 1;
  shape.e2[*axes_->find('Y')] = 1;
  shape.radius = begin_radius_mm_;
  shape.radius_slope = radius_change_mm_ / length;
  shape.angle_rad = begin_rad_;
  shape.rate = turn_rad_ / length;
  return Curve::arc(shape, to_, length, axes_->count());
}

// By the angle it is the integral of √(r² + c²), c the change of radius and height for a radian:
// Simpson's rule on so many parts.
double TurningRapid::length_mm() const {
  constexpr int kParts = 256;
  const auto z = axes_->find('Z');
  const double rise = z ? (to_[*z] - from_[*z]) / turn_rad_ : 0;
  const double other = math::hypot(radius_change_mm_ / turn_rad_, rise);
  double sum = 0;
  for (int i = 0; i <= kParts; ++i) {
    const double radius = begin_radius_mm_ + radius_change_mm_ * i / kParts;
    const double weight = i == 0 || i == kParts ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * math::hypot(radius, other);
  }
  return std::fabs(turn_rad_) * sum / (3 * kParts);
}

}  // namespace kerf::motion
