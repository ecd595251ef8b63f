#pragma once

#include "geometry/contour/edge.hpp"
#include "geometry/vec3.hpp"
#include "process/recipe.hpp"

namespace kerf::process {

using geometry::Vec3;

/// A place of the surface that a drawing lies on, and what is square to it there, outwards.
struct SurfacePose {
  Vec3 at;
  Vec3 normal;
};

/// The surface of [wrap], seen from outside, with the zero of the drawing on top of it (of a
/// cylinder about Z at +X). Cylinders and cones are unrolled: lengths and angles are true. On a
/// sphere a place is as far from the top as it is from zero, in the same direction.
///
///   cylinder X   (x, R sin φ, R cos φ)         φ = y / R
///            Y   (R sin φ, y, R cos φ)         φ = x / R
///            Z   (R cos φ, R sin φ, y)         φ = x / R
///   cone         apex + s (sin β cos φ, sin β sin φ, -cos β)   s = |(x, y - at)|, φ = ψ / sin β,
///                ψ = atan2(x, at - y)
///   sphere       R (sin α cos δ, sin α sin δ, cos α)           α = |(x, y)| / R, δ = atan2(y, x)
class WrappedSurface {
 public:
  explicit WrappedSurface(const Wrap& wrap);

  [[nodiscard]] SurfacePose pose(Vec2 at) const;
  /// From the surface, mm, of either sign.
  [[nodiscard]] double distance(Vec3 point) const;
  /// Whether the edge goes round the axis alone, so that it is an arc in space with one tilt.
  [[nodiscard]] bool goes_round(const contour::Edge& edge) const;
  /// Whether it is a line in space along which nothing turns.
  [[nodiscard]] bool stays_straight(const contour::Edge& edge) const;
  /// How far it turns about the axis along an edge that goes round, radians, >= 0.
  [[nodiscard]] double turn_rad(const contour::Edge& edge) const;
  /// How much longer things get across the way from the zero at this place: 1 but on a sphere.
  [[nodiscard]] double stretch(Vec2 at) const;

 private:
  [[nodiscard]] SurfacePose on_cylinder(Vec2 at) const;
  [[nodiscard]] SurfacePose on_cone(Vec2 at) const;
  [[nodiscard]] SurfacePose on_sphere(Vec2 at) const;

  Wrap wrap_;
  Vec3 centre_;
  double sine_ = 0;  // of a cone's half angle
  double cosine_ = 1;
};

}  // namespace kerf::process
