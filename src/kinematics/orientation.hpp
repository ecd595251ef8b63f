#pragma once

#include <array>

#include "geometry/vec3.hpp"
#include "kinematics/fault.hpp"

namespace kerf::kinematics {

/// Tilt A and turn C of a head, degrees.
struct HeadAngles {
  double a_deg = 0;
  double c_deg = 0;
};

/// Unit vector from the focus to the head: the surface's outward normal when the beam is square to
/// it (docs/kinematics.md, Head).
[[nodiscard]] geometry::Vec3 beam_axis(HeadAngles angles);

/// Both positions of the head with the beam along `normal`, of any length but 0: A in [0, 180],
/// then the same turned over, -A and C + 180; C on the turn nearest to `previous`. Where the beam
/// is vertical (|sin A| < 1e-9) C is open and both are that of `previous`, A exactly 0 or ±180.
/// Error singular: `normal` has no direction.
[[nodiscard]] Result<std::array<HeadAngles, 2>> orientations(geometry::Vec3 normal,
                                                             HeadAngles previous);

/// The one of them with the smaller |ΔA| + |ΔC| from `previous`; the first when equal.
[[nodiscard]] Result<HeadAngles> orientation(geometry::Vec3 normal, HeadAngles previous);

/// Unit normal of the surface through three points that were touched on it, in any order: of its
/// two directions the one towards the head, which is that with `beam` (beam_axis() when they were
/// touched). Error singular: the points lie on one line, or the beam lies in the surface.
[[nodiscard]] Result<geometry::Vec3> surface_normal(geometry::Vec3 q1, geometry::Vec3 q2,
                                                    geometry::Vec3 q3, geometry::Vec3 beam);

/// How far the beam is from its shortest turn, at most, while A and C go from `from` to `to` in
/// proportion, degrees: the angle between it and the direction that turns from one end to the other
/// on a great circle at an even rate. Where both ends are square to a surface that turns so, this
/// is what the beam is off square between them. Looked at in 1/256 of the way; 180 where the ends
/// are opposite to each other, when every turn is the shortest.
[[nodiscard]] double most_off_shortest_turn_deg(HeadAngles from, HeadAngles to);

}  // namespace kerf::kinematics
