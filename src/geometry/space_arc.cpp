#include "geometry/space_arc.hpp"

#include <algorithm>
#include <numbers>
#include <optional>

#include "geometry/tolerance.hpp"
#include "math/math.hpp"

namespace kerf::geometry {
namespace {

constexpr double kFlat = 1e-9;  // sine below which three points lie on one line
constexpr double kFullTurn_rad = 2 * std::numbers::pi;

bool same(Vec3 a, Vec3 b) { return length(a - b) <= kSamePoint_mm; }

std::optional<NoArc> objection(Vec3 p1, Vec3 p2, Vec3 p3) {
  if (same(p1, p2) || same(p2, p3) || same(p3, p1)) return NoArc::coincident;
  const Vec3 u = p2 - p1;
  const Vec3 v = p3 - p1;
  const double reach = std::max(length(u), length(v));
  if (length(cross(u, v)) > kFlat * reach * reach) return std::nullopt;
  return dot(u, p3 - p2) > 0 ? NoArc::straight : NoArc::collinear;
}

// A corner of the triangle P1 P2 P3 and the sides from there to the next corner and the one after.
struct Corner {
  Vec3 point;
  Vec3 next;
  Vec3 after;
};

// The corner opposite to the longest side: what is computed from it cancels least.
Corner best_corner(Vec3 p1, Vec3 p2, Vec3 p3) {
  const double opposite_1 = length(p3 - p2);
  const double opposite_2 = length(p1 - p3);
  const double opposite_3 = length(p2 - p1);
  if (opposite_1 >= opposite_2 && opposite_1 >= opposite_3) return {p1, p2 - p1, p3 - p1};
  if (opposite_2 >= opposite_3) return {p2, p3 - p2, p1 - p2};
  return {p3, p1 - p3, p2 - p3};
}

// From a corner of a triangle to the centre of its circle; `w` = next × after.
Vec3 to_centre(const Corner& corner, Vec3 w) {
  const Vec3& u = corner.next;
  const Vec3& v = corner.after;
  return (1 / (2 * dot(w, w))) * (dot(v, v) * cross(w, u) + dot(u, u) * cross(v, w));
}

// Angle at the centre over the side from `a` to `b`: twice the angle at the third corner.
double central_angle(Vec3 a, Vec3 b, Vec3 third, double twice_area) {
  return 2 * math::atan2(twice_area, dot(a - third, b - third));
}

}  // namespace

tl::expected<SpaceArc, NoArc> SpaceArc::through(Vec3 p1, Vec3 p2, Vec3 p3) {
  if (const auto why = objection(p1, p2, p3)) return tl::unexpected(*why);
  return SpaceArc(p1, p2, p3);
}

tl::expected<SpaceArc, NoArc> SpaceArc::circle(Vec3 p1, Vec3 p2, Vec3 p3) {
  if (const auto why = objection(p1, p2, p3))
    return tl::unexpected(*why == NoArc::straight ? NoArc::collinear : *why);
  SpaceArc arc(p1, p2, p3);
  arc.end_ = p1;
  arc.sweep_rad_ = kFullTurn_rad;
  return arc;
}

SpaceArc::SpaceArc(Vec3 p1, Vec3 p2, Vec3 p3) : begin_(p1), end_(p3) {
  const Corner corner = best_corner(p1, p2, p3);
  const Vec3 w = cross(corner.next, corner.after);
  centre_ = corner.point + to_centre(corner, w);
  radius_ = geometry::length(p1 - centre_);
  e3_ = unit(w);
  const Vec3 arm = p1 - centre_;
  e1_ = unit(arm - dot(arm, e3_) * e3_);
  e2_ = cross(e3_, e1_);
  const double twice_area = geometry::length(w);
  to_second_rad_ = central_angle(p1, p2, p3, twice_area);
  to_third_rad_ = to_second_rad_ + central_angle(p2, p3, p1, twice_area);
  sweep_rad_ = to_third_rad_;
}

// From P1, not from the centre, which may lie very far away: cos θ - 1 = -2 sin²(θ/2).
Vec3 SpaceArc::at(double angle_rad) const {
  if (angle_rad <= 0) return begin_;
  if (angle_rad >= sweep_rad_) return end_;
  const double half = math::sin(angle_rad / 2);
  return begin_ + (-2 * radius_ * half * half) * e1_ + (radius_ * math::sin(angle_rad)) * e2_;
}

Vec3 SpaceArc::tangent(double angle_rad) const {
  const auto [sine, cosine] = math::sine_cosine(angle_rad);
  return -sine * e1_ + cosine * e2_;
}

double SpaceArc::farthest_rad(Vec3 direction) const {
  const double angle = math::atan2(dot(direction, e2_), dot(direction, e1_));
  const double turned = angle < 0 ? angle + kFullTurn_rad : angle;
  return turned < kFullTurn_rad ? turned : 0;
}

}  // namespace kerf::geometry
