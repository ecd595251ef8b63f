#include "kinematics/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angle.hpp"
#include "math/math.hpp"

namespace kerf::kinematics {
namespace {

using geometry::degrees;
using geometry::nearest_turn;
using geometry::Vec3;

constexpr double kVerticalSine = 1e-9;
constexpr double kEqual_deg = 1e-9;
constexpr double kFlat = 1e-9;  // sine below which points lie on a line, or a beam in a surface
constexpr int kLooks = 256;     // of a turn, on the way

double turned_deg(HeadAngles from, HeadAngles to) {
  return std::fabs(to.a_deg - from.a_deg) + std::fabs(to.c_deg - from.c_deg);
}

double angle_rad(Vec3 a, Vec3 b) { return math::atan2(length(cross(a, b)), dot(a, b)); }

// The unit vector at a share of the great circle between two of them, `angle` > 0 apart.
Vec3 on_great_circle(Vec3 from, Vec3 to, double angle, double share) {
  return (1 / math::sin(angle)) *
         (math::sin((1 - share) * angle) * from + math::sin(share * angle) * to);
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
  const double level = math::hypot(normal.x, normal.y);
  if (level < kVerticalSine * size) {
    const double a_deg = normal.z > 0 ? 0 : 180;
    return std::array{HeadAngles{a_deg, previous.c_deg}, HeadAngles{0 - a_deg, previous.c_deg}};
  }
  const double a_deg = degrees(math::atan2(level, normal.z));
  const double c_deg = degrees(math::atan2(normal.x, -normal.y));
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

Result<Vec3> surface_normal(Vec3 q1, Vec3 q2, Vec3 q3, Vec3 beam) {
  const Vec3 u = q2 - q1;
  const Vec3 v = q3 - q1;
  const Vec3 w = cross(u, v);
  if (!(length(w) > kFlat * length(u) * length(v)))
    return base::unexpected(
        Fault{Fault::Kind::singular, "the three points lie on one line, so they are no surface"});
  const Vec3 normal = unit(w);
  const double with_beam = dot(normal, beam);
  if (!(std::fabs(with_beam) > kFlat * length(beam)))
    return base::unexpected(Fault{Fault::Kind::singular,
                                  "the beam lies in the surface, so neither side is the head's"});
  return with_beam > 0 ? normal : -1.0 * normal;
}

double most_off_shortest_turn_deg(HeadAngles from, HeadAngles to) {
  const Vec3 begin = beam_axis(from);
  const Vec3 end = beam_axis(to);
  const double turn_rad = angle_rad(begin, end);
  if (turn_rad > std::numbers::pi - kFlat) return 180;
  double most_rad = 0;
  for (int i = 1; i < kLooks; ++i) {
    const double share = static_cast<double>(i) / kLooks;
    const Vec3 beam = beam_axis({from.a_deg + share * (to.a_deg - from.a_deg),
                                 from.c_deg + share * (to.c_deg - from.c_deg)});
    const Vec3 shortest = turn_rad > kFlat ? on_great_circle(begin, end, turn_rad, share) : begin;
    most_rad = std::max(most_rad, angle_rad(beam, shortest));
  }
  return degrees(most_rad);
}

}  // namespace kerf::kinematics
