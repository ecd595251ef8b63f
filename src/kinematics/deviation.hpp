#pragma once

#include "kinematics/settings.hpp"

// How far the tip leaves the straight line between two samples because the joints, not the tip,
// move in proportion (docs/kinematics.md, Between two samples). Each is an upper bound; differences
// of angles are of any sign and size.

namespace kerf::kinematics {

/// Tilt and turn of a head while its carriage moves straight.
[[nodiscard]] double head_deviation_mm(const HeadRadii& radii, double delta_a_deg,
                                       double delta_c_deg);

/// `radius_mm` >= 0 is the distance from the axis, that of both ends which gives more. The root of
/// the bound is a norm of both differences; infinite on the axis, 0 there where nothing moves.
[[nodiscard]] double polar_deviation_mm(double radius_mm, double delta_x_mm,
                                        double delta_theta_deg);

/// The angles of both links are counted from +X, so that of the forearm holds the elbow's and the
/// upper arm's.
[[nodiscard]] double arm_deviation_mm(const ArmLinks& links, double delta_upper_deg,
                                      double delta_forearm_deg);

/// Tip of an arm at `radius_mm` from the shoulder when each joint is off by up to `off_deg` >= 0:
/// half a pulse for rounded samples, the same once more while pulses come one by one. For joints
/// where T1 counts from T2.
[[nodiscard]] double arm_rounding_mm(const ArmLinks& links, double radius_mm, double off_deg);

/// Curve of radius `radius_mm` > 0 against the chord over `step_mm` of its length, step <= radius.
[[nodiscard]] double sampling_deviation_mm(double step_mm, double radius_mm);

}  // namespace kerf::kinematics
