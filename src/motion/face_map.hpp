#pragma once

#include "base/path_jet.hpp"
#include "geometry/vec2.hpp"
#include "motion/motion.hpp"

namespace kerf::motion {

/// Largest absolute values of the derivatives by the path parameter, per axis.
struct CurveBounds {
  base::AxisVector first;
  base::AxisVector second;
  base::AxisVector third;
};

/// Bounds of a curve z(s) in a plane with the centre of rotation as its origin, over a part of it:
/// the least and the largest |z|, which are > 0, and the largest values of the others.
struct FlatBounds {
  double nearest = 0;
  double farthest = 0;
  double speed = 0;          ///< |z'|
  double turning = 0;        ///< |z × z'|
  double receding = 0;       ///< |z · z'|
  double bend = 0;           ///< |z''|
  double bend_turning = 0;   ///< |z × z''|
  double bend_receding = 0;  ///< |z · z''|
  double third = 0;          ///< |z'''|
};

/// The bounds of z = point + slope s for s in [from, to].
[[nodiscard]] FlatBounds bounds_of_line(geometry::Vec2 point, geometry::Vec2 slope, double from,
                                        double to);

/// An arc's radius and angle, both linear in s.
struct FlatArc {
  double radius = 0;
  double radius_slope = 0;
  double angle_rad = 0;
  double rate = 0;
};
/// The bounds of z = centre + r(s) (cos φ(s), sin φ(s)) for s in [from, to].
[[nodiscard]] FlatBounds bounds_of_arc(geometry::Vec2 centre, const FlatArc& arc, double from,
                                       double to);

/// From the plane of a face to the machine, for a short way that turns by less than a half turn and
/// does not touch the centre:
///
///   x = centre + side |z|,   c = c of the begin + the angle from the begin to z
///
/// With z'/z = q, a complex number: ρ'/ρ = Re q and c' = Im q, and so on. Value type.
struct FaceMap {
  base::Axis first{};
  base::Axis rotary{};
  double centre_mm = 0;
  double side = 1;
  geometry::Vec2 begin;  ///< a place on the way, mm, and there
  double begin_deg = 0;  ///< the rotary axis

  [[nodiscard]] geometry::Vec2 flat(const base::AxisVector& v) const {
    return {v[first], v[rotary]};
  }
  [[nodiscard]] base::TipPoint point(base::TipPoint flat_point) const;
  [[nodiscard]] base::TipJet jet(const base::TipJet& flat_jet) const;
  /// `own` are those of all axes in the plane.
  [[nodiscard]] CurveBounds bounds(CurveBounds own, const FlatBounds& flat) const;
  /// Bound of the second derivative that makes two axes at constant rates leave the curve, mm.
  [[nodiscard]] double bend(const CurveBounds& bounds, const FlatBounds& flat) const;
};

}  // namespace kerf::motion
