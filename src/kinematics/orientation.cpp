#include "kinematics/orientation.hpp"

#include <cmath>

#include "geometry/angle.hpp"

namespace kerf::kinematics {
namespace {

using geometry::degrees;
using geometry::nearest_turn;
using geometry::Vec3;

constexpr double kVerticalSine = 1e-9;
constexpr double kEqual_deg = 1e-9;

double turned_deg(HeadAngles from, HeadAngles to) {
  return std::fabs(to.a_deg - from.a_deg) + std::fabs(to.c_deg - from.c_deg);
}

}  // namespace

Vec3 beam_axis(HeadAngles angles) {
  const auto [sa, ca] = geometry::sine_cosine_deg(angles.a_deg);
  const auto [sc, cc] = geometry::sine_cosine_deg(angles.c_deg);
  return {sa * sc, -sa * cc, ca};
}

Result<std::array<HeadAngles, 2>> orientations(Vec3 normal, HeadAngles previous) {
  const double size = length(normal);
  if (!(size > 0)) {
    return base::unexpected(
        Fault{Fault::Kind::singular, "the surface normal has no length, so the beam no direction"});
  }
  const double level = std::hypot(normal.x, normal.y);
  if (level < kVerticalSine * size) {
    const double a_deg = normal.z > 0 ? 0 : 180;
    return std::array{HeadAngles{a_deg, previous.c_deg}, HeadAngles{0 - a_deg, previous.c_deg}};
  }
  const double a_deg = degrees(std::atan2(level, normal.z));
  const double c_deg = degrees(std::atan2(normal.x, -normal.y));
  return std::array{HeadAngles{a_deg, nearest_turn(c_deg, previous.c_deg)},
                    HeadAngles{-a_deg, nearest_turn(c_deg + 180, previous.c_deg)}};
}

Result<HeadAngles> orientation(Vec3 normal, HeadAngles previous) {
  const auto both = orientations(normal, previous);
  if (!both) return base::unexpected(both.error());
  const auto& [first, second] = *both;
  const bool second_is_nearer =
      turned_deg(previous, second) < turned_deg(previous, first) - kEqual_deg;
  return second_is_nearer ? second : first;
}

}  // namespace kerf::kinematics
