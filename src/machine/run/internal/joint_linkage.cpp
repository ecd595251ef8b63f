#include "machine/run/internal/joint_linkage.hpp"

namespace kerf::machine {

base::JointPoint JointLinkage::joints(const base::TipPoint& tip,
                                      const base::JointPoint& previous) const {
  const auto joints = kinematics_.follow(tip, previous);
  return joints ? *joints : previous;
}

std::optional<base::JointJet> JointLinkage::along(const base::TipJet& tip,
                                                  const base::JointPoint& joints) const {
  const auto jet = kinematics_.along(tip, joints);
  return jet ? std::optional(*jet) : std::nullopt;
}

double JointLinkage::tip_way_mm(const base::JointPoint& joints, const base::AxisVector& way) const {
  return geometry::length(kinematics_.tip_rates(joints, way));
}

double JointLinkage::swing_mm(const base::JointPoint& joints, const base::AxisVector& rates) const {
  return kinematics_.swing_bound_mm(joints, rates);
}

}  // namespace kerf::machine
