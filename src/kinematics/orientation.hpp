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

}  // namespace kerf::kinematics
