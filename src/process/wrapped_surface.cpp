#include "process/wrapped_surface.hpp"

#include <cmath>
#include <numbers>

namespace kerf::process {
namespace {

using contour::Edge;
using Shape = Wrap::Shape;

constexpr double kSame_mm = 1e-9;

/// The middle of what goes round: the apex of an unrolled cone, the top of a sphere.
Vec2 pole_of(const Wrap& wrap) { return wrap.shape == Shape::cone ? Vec2{0, wrap.at} : Vec2{}; }

bool is_arc_about(const Edge& edge, Vec2 pole) {
  return edge.bulge != 0 && geometry::length(centre(edge) - pole) <= 1e-6;
}

}  // namespace

WrappedSurface::WrappedSurface(const Wrap& wrap)
    : wrap_(wrap), centre_{wrap.centre[0], wrap.centre[1], wrap.centre[2]} {
  const auto [sine, cosine] = math::sine_cosine(wrap.half_angle_deg * std::numbers::pi / 180);
  sine_ = sine;
  cosine_ = cosine;
}

SurfacePose WrappedSurface::pose(Vec2 at) const {
  switch (wrap_.shape) {
    case Shape::none: break;
    case Shape::cylinder: return on_cylinder(at);
    case Shape::cone: return on_cone(at);
    case Shape::sphere: return on_sphere(at);
  }
  return {{at.u, at.v, 0}, {0, 0, 1}};
}

SurfacePose WrappedSurface::on_cylinder(Vec2 at) const {
  const double radius = wrap_.radius;
  const auto [sine, cosine] = math::sine_cosine((wrap_.axis == 'X' ? at.v : at.u) / radius);
  Vec3 normal{cosine, sine, 0};
  Vec3 along{0, 0, at.v};
  if (wrap_.axis == 'X') {
    normal = {0, sine, cosine};
    along = {at.u, 0, 0};
  } else if (wrap_.axis == 'Y') {
    normal = {sine, 0, cosine};
    along = {0, at.v, 0};
  }
  return {centre_ + along + radius * normal, normal};
}

SurfacePose WrappedSurface::on_cone(Vec2 at) const {
  const Vec2 from_apex = at - pole_of(wrap_);
  const double slant = geometry::length(from_apex);
  const double turn = slant > kSame_mm ? math::atan2(from_apex.u, -from_apex.v) / sine_ : 0;
  const auto [sine, cosine] = math::sine_cosine(turn);
  const Vec3 down{sine_ * cosine, sine_ * sine, -cosine_};
  return {centre_ + slant * down, {cosine_ * cosine, cosine_ * sine, sine_}};
}

SurfacePose WrappedSurface::on_sphere(Vec2 at) const {
  const double away = geometry::length(at);
  const auto [sine, cosine] = math::sine_cosine(away / wrap_.radius);
  const Vec2 towards = away > kSame_mm ? (1 / away) * at : Vec2{1, 0};
  const Vec3 normal{sine * towards.u, sine * towards.v, cosine};
  return {centre_ + wrap_.radius * normal, normal};
}

double WrappedSurface::distance(Vec3 point) const {
  const Vec3 from = point - centre_;
  switch (wrap_.shape) {
    case Shape::none: return point.z;
    case Shape::sphere: return geometry::length(from) - wrap_.radius;
    case Shape::cone: return math::hypot(from.x, from.y) * cosine_ + from.z * sine_;
    case Shape::cylinder: break;
  }
  if (wrap_.axis == 'X') return math::hypot(from.y, from.z) - wrap_.radius;
  if (wrap_.axis == 'Y') return math::hypot(from.x, from.z) - wrap_.radius;
  return math::hypot(from.x, from.y) - wrap_.radius;
}

bool WrappedSurface::goes_round(const Edge& edge) const {
  if (wrap_.shape != Shape::cylinder) return is_arc_about(edge, pole_of(wrap_));
  const Vec2 way = edge.to - edge.from;
  return edge.bulge == 0 && std::abs(wrap_.axis == 'X' ? way.u : way.v) <= kSame_mm;
}

bool WrappedSurface::stays_straight(const Edge& edge) const {
  if (edge.bulge != 0) return false;
  const Vec2 way = edge.to - edge.from;
  if (wrap_.shape == Shape::cylinder)
    return std::abs(wrap_.axis == 'X' ? way.v : way.u) <= kSame_mm;
  if (wrap_.shape != Shape::cone) return false;
  const Vec2 from = edge.from - pole_of(wrap_);
  const Vec2 to = edge.to - pole_of(wrap_);
  const bool is_one_ray = std::abs(geometry::cross(from, to)) <= kSame_mm * geometry::length(from);
  return is_one_ray && geometry::dot(from, to) > 0;
}

double WrappedSurface::turn_rad(const Edge& edge) const {
  if (wrap_.shape == Shape::cylinder) return length(edge) / wrap_.radius;
  const double sweep = std::abs(sweep_rad(edge));
  return wrap_.shape == Shape::cone ? sweep / sine_ : sweep;
}

double WrappedSurface::stretch(Vec2 at) const {
  const double angle = geometry::length(at) / wrap_.radius;
  if (wrap_.shape != Shape::sphere || angle < 1e-9) return 1;
  return angle / std::abs(math::sin(angle));
}

}  // namespace kerf::process
