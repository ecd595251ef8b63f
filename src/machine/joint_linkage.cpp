#include "machine/internal/joint_linkage.hpp"

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

double JointLinkage::deviation_mm(const base::AxisVector& from, const base::AxisVector& to) const {
  return kinematics_.deviation_bound_mm(from, to);
}

}  // namespace kerf::machine
