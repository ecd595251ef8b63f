#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kinematics/joint.hpp"

namespace kerf::kinematics {

enum class Kind : std::uint8_t { cartesian, x_theta_z, head_ac, arm };

/// What the X-θ-Z machine stands at when its joints are 0. Any sign.
struct XThetaZOffsets {
  double x1_mm = 0;       ///< distance of the tip from the axis of the work
  double theta0_deg = 0;  ///< angle of the work under the tip
  double z0_mm = 0;       ///< height of the focus
};

/// Rotation radii of the A/C head. Any sign.
struct HeadRadii {
  double r_a_mm = 150;  ///< from the focus to the axis of A
  double r_c_mm = 80;   ///< from there to the axis of C
};

/// Links of the arm, lengths > 0.
struct ArmLinks {
  double upper_arm_mm = 132;
  double forearm_mm = 132;
  bool forearm_absolute = false;  ///< T1 counts from +X (driven by a parallel linkage), not from T2
  /// The side of the elbow, T1 negative, to which a stretched or folded arm bends: so does the run
  /// that begins there.
  bool elbow_minus = false;
};

/// Where the rotary axes that turn the work lie: a point on each, machine coordinates, mm, all
/// rotary axes at 0. The primary one carries the other.
struct TablePoints {
  std::array<double, 3> primary{};
  std::array<double, 3> secondary{};
};

/// Everything that makes a linkage. Only the part of its kind is read.
struct Settings {
  Kind kind = Kind::cartesian;
  std::vector<Joint> joints;  ///< in the order of the machine file
  XThetaZOffsets x_theta_z{};
  HeadRadii head{};
  ArmLinks arm{};
  TablePoints tables{};  ///< of a Cartesian machine
};

}  // namespace kerf::kinematics
