#include "stock/dexel/across.hpp"

#include <algorithm>
#include <cmath>

#include "math/math.hpp"
#include "stock/sweep/outcome.hpp"

namespace kerf::stock::dexel {
namespace {

constexpr double kStill_mm = 1e-9;

}  // namespace

Across::Across(const Sweep& sweep, double radius_mm)
    : scale_(static_cast<double>(Outcome::kBins) / (2 * radius_mm)) {
  if (!(radius_mm > 0)) return;
  std::visit([&](const auto& way) { take(way, sweep.axis); }, sweep.way);
}

void Across::take(const StraightWay& way, Vec3 axis) {
  take_plane(way.from, way.to - way.from, axis);
}

void Across::take(const ArcWay& way, Vec3 axis) {
  const double lean = dot(cross(way.e1, way.e2), axis);
  if (std::fabs(lean) < 0.5) {
    take_plane(point_at(way, 0), point_at(way, 1e-6) - point_at(way, 0), axis);
    return;
  }
  kind_ = Kind::ring;
  from_ = way.centre;
  left_ = way.e1;
  other_ = way.e2;
  radius_ = std::fabs(way.radius + way.radius_change / 2);
  side_ = way.turn_rad * lean > 0 ? 1 : -1;
}

void Across::take_plane(Vec3 from, Vec3 along, Vec3 axis) {
  const Vec3 left = cross(axis, along);
  const double size = std::sqrt(dot(left, left));
  from_ = from;
  axis_ = axis;
  kind_ = size < kStill_mm ? Kind::axis : Kind::plane;
  if (kind_ == Kind::axis) return;
  left_ = (1 / size) * left;
}

double Across::distance(Vec3 place) const {
  const Vec3 v = place - from_;
  if (kind_ == Kind::plane) return dot(v, left_);
  if (kind_ == Kind::axis) {
    const Vec3 out = v - dot(v, axis_) * axis_;
    return std::sqrt(dot(out, out));
  }
  return side_ * (radius_ - math::hypot(dot(v, left_), dot(v, other_)));
}

std::size_t Across::bin(double distance) const {
  constexpr double kHalf = static_cast<double>(Outcome::kBins) / 2;
  constexpr double kLast = static_cast<double>(Outcome::kBins) - 1;
  return static_cast<std::size_t>(std::clamp(distance * scale_ + kHalf, 0.0, kLast));
}

}  // namespace kerf::stock::dexel
