#include "kinematics/internal/cartesian.hpp"

#include <utility>

namespace kerf::kinematics {

using base::AxisVector;
using base::PathJet;

// Also a rotary axis keeps the program's turn: nothing of it is computed.
Cartesian::Cartesian(std::vector<Joint> joints) : Kinematics(std::move(joints), Turns{}) {}

AxisVector Cartesian::forward(const AxisVector& joints) const { return joints; }

Result<AxisVector> Cartesian::solve(const AxisVector& tip, const AxisVector& /*previous*/,
                                    Branch /*branch*/) const {
  return tip;
}

Result<PathJet> Cartesian::along(const PathJet& tip, const AxisVector& joints) const {
  PathJet result = tip;
  result.value = joints;
  return result;
}

double Cartesian::deviation_bound_mm(const AxisVector& /*from*/, const AxisVector& /*to*/) const {
  return 0;
}

}  // namespace kerf::kinematics
