#include "geometry/angle.hpp"

#include <cmath>

#include "geometry/tolerance.hpp"
#include "math/math.hpp"

namespace kerf::geometry {

SineCosine sine_cosine_deg(double angle_deg) {
  if (!(std::fabs(angle_deg) < 0x1p44)) angle_deg = std::fmod(angle_deg, 360);
  const double quarters = std::nearbyint(angle_deg / 90);
  const double rest_rad = (angle_deg - quarters * 90) * std::numbers::pi / 180;
  const auto [s, c] = math::sine_cosine(rest_rad);
  switch (static_cast<long long>(quarters) & 3) {
    case 0: return {s, c};
    case 1: return {c, -s};
    case 2: return {-s, -c};
    default: return {-c, s};
  }
}

double nearest_turn(double angle_deg, double previous_deg, double turn_deg) {
  const double turns = std::floor((angle_deg - previous_deg) / turn_deg + 0.5);
  return angle_deg - turn_deg * turns;
}

double heading_deg(Vec2 from, Vec2 to) {
  constexpr double kNearlyFullTurn_deg = 360 - 1e-6;
  const Vec2 way = to - from;
  if (length(way) <= kSamePoint_mm) return kNoHeading_deg;
  const double angle = degrees(math::atan2(way.v, way.u));
  const double turned = angle < 0 ? angle + 360 : angle;
  return turned < kNearlyFullTurn_deg ? turned : 0;
}

}  // namespace kerf::geometry
