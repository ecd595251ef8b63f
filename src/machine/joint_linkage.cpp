#include "machine/internal/joint_linkage.hpp"

namespace kerf::machine {

base::AxisVector JointLinkage::joints(const base::AxisVector& tip,
                                      const base::AxisVector& previous) const {
  const auto joints = kinematics_.inverse(tip, previous);
  return joints ? *joints : previous;
}

// At a singular position the joints would have to be infinitely fast: the planner then creeps.
base::PathJet JointLinkage::along(const base::PathJet& tip,
                                  const base::AxisVector& previous) const {
  constexpr double kVeryLarge = 1e9;
  const base::AxisVector at = joints(tip.value, previous);
  if (const auto jet = kinematics_.along(tip, at)) return *jet;
  base::PathJet jet;
  jet.value = at;
  for (std::size_t m = 0; m < kinematics_.size(); ++m) {
    jet.first.values[m] = kVeryLarge;
    jet.second.values[m] = kVeryLarge;
    jet.third.values[m] = kVeryLarge;
  }
  return jet;
}

double JointLinkage::deviation_mm(const base::AxisVector& from, const base::AxisVector& to) const {
  return kinematics_.deviation_bound_mm(from, to);
}

}  // namespace kerf::machine
