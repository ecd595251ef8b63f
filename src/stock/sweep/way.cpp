#include "stock/sweep/way.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/math.hpp"

namespace kerf::stock {
namespace {

using std::numbers::pi;

Vec3 between(Vec3 from, Vec3 to, double t) { return from + t * (to - from); }

Bounds around(Vec3 a, Vec3 b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
          {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
}

/// Smallest and largest of u cos φ + v sin φ over the angles of the way, for a radius of 1.
struct Swing {
  double low;
  double high;
};
Swing swing(double u, double v, const ArcWay& way) {
  const double from = std::min(way.angle_rad, way.angle_rad + way.turn_rad);
  const double to = std::max(way.angle_rad, way.angle_rad + way.turn_rad);
  const auto value = [&](double angle) { return u * math::cos(angle) + v * math::sin(angle); };
  const double most = math::hypot(u, v);
  const double top = math::atan2(v, u);
  const auto reaches = [&](double angle) {
    return angle + 2 * pi * std::ceil((from - angle) / (2 * pi)) <= to;
  };
  Swing range{std::min(value(from), value(to)), std::max(value(from), value(to))};
  if (reaches(top)) range.high = most;
  if (reaches(top + pi)) range.low = -most;
  return range;
}

/// Along one axis: `centre`, `rise`, e1 and e2 are its components.
void bound(double centre, double rise, double e1, double e2, const ArcWay& way, double& low,
           double& high) {
  const Swing s = swing(e1, e2, way);
  const double first = way.radius;
  const double last = way.radius + way.radius_change;
  low = centre + std::min(0.0, rise) + std::min(first * s.low, last * s.low);
  high = centre + std::max(0.0, rise) + std::max(first * s.high, last * s.high);
}

Bounds bounds_of(const StraightWay& way) { return around(way.from, way.to); }
Bounds bounds_of(const TurningWay& way) { return around(way.from, way.to); }
Bounds bounds_of(const ArcWay& way) {
  Bounds box;
  bound(way.centre.x, way.rise.x, way.e1.x, way.e2.x, way, box.low.x, box.high.x);
  bound(way.centre.y, way.rise.y, way.e1.y, way.e2.y, way, box.low.y, box.high.y);
  bound(way.centre.z, way.rise.z, way.e1.z, way.e2.z, way, box.low.z, box.high.z);
  return box;
}

double length_of(const StraightWay& way) { return geometry::length(way.to - way.from); }
double length_of(const TurningWay& way) { return geometry::length(way.to - way.from); }
double length_of(const ArcWay& way) {
  const double mean = way.radius + way.radius_change / 2;
  return math::hypot(mean * way.turn_rad, geometry::length(way.rise), way.radius_change);
}

}  // namespace

Vec3 point_at(const StraightWay& way, double t) { return between(way.from, way.to, t); }
Vec3 point_at(const TurningWay& way, double t) { return between(way.from, way.to, t); }

Vec3 point_at(const ArcWay& way, double t) {
  const double radius = way.radius + t * way.radius_change;
  const double angle = way.angle_rad + t * way.turn_rad;
  return way.centre + t * way.rise + (radius * math::cos(angle)) * way.e1 +
         (radius * math::sin(angle)) * way.e2;
}

Vec3 point_at(const Way& way, double t) {
  return std::visit([t](const auto& one) { return point_at(one, t); }, way);
}

double length(const Way& way) {
  return std::visit([](const auto& one) { return length_of(one); }, way);
}

StraightWay part(const StraightWay& way, double from, double to) {
  return {point_at(way, from), point_at(way, to)};
}

ArcWay part(const ArcWay& way, double from, double to) {
  ArcWay cut = way;
  cut.centre = way.centre + from * way.rise;
  cut.rise = (to - from) * way.rise;
  cut.radius = way.radius + from * way.radius_change;
  cut.radius_change = (to - from) * way.radius_change;
  cut.angle_rad = way.angle_rad + from * way.turn_rad;
  cut.turn_rad = (to - from) * way.turn_rad;
  return cut;
}

Bounds bounds(const Way& way) {
  return std::visit([](const auto& one) { return bounds_of(one); }, way);
}

}  // namespace kerf::stock
