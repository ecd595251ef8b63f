#include "machine/internal/joint_linkage.hpp"

#include <cmath>

namespace kerf::machine {

base::AxisVector JointLinkage::joints(const base::AxisVector& tip,
                                      const base::AxisVector& previous) const {
  const auto joints = kinematics_.follow(tip, previous);
  return joints ? *joints : previous;
}

std::optional<base::PathJet> JointLinkage::along(const base::PathJet& tip,
                                                 const base::AxisVector& joints) const {
  const auto jet = kinematics_.along(tip, joints);
  return jet ? std::optional(*jet) : std::nullopt;
}

// Each joint adds at most what it alone gives the tip, whose first axes are X, Y and Z.
double JointLinkage::tip_acceleration(const base::AxisVector& joints,
                                      const base::AxisVector& accelerations) const {
  constexpr double kSmallMove = 1e-5;  // mm, degrees
  double sum = 0;
  for (std::size_t m = 0; m < kinematics_.size(); ++m) {
    base::AxisVector low = joints, high = joints;
    low.values[m] -= kSmallMove;
    high.values[m] += kSmallMove;
    const base::AxisVector way = kinematics_.forward(high) - kinematics_.forward(low);
    sum += std::hypot(way.values[0], way.values[1], way.values[2]) / (2 * kSmallMove) *
           accelerations.values[m];
  }
  return sum;
}

double JointLinkage::deviation_mm(const base::AxisVector& from, const base::AxisVector& to) const {
  return kinematics_.deviation_bound_mm(from, to);
}

}  // namespace kerf::machine
