#include "kinematics/internal/cartesian.hpp"

#include <utility>

namespace kerf::kinematics {

using base::AxisVector;

// Also a rotary axis keeps the program's turn: nothing of it is computed.
Cartesian::Cartesian(std::vector<Joint> joints) : Kinematics(std::move(joints), Turns{}) {}

AxisVector Cartesian::forward(const AxisVector& joints) const { return joints; }

Result<AxisVector> Cartesian::solve(const AxisVector& tip, const AxisVector& /*previous*/,
                                    Branch /*branch*/) const {
  return tip;
}

Result<Derivatives> Cartesian::derivatives(const AxisVector& /*tip*/, const AxisVector& /*joints*/,
                                           const AxisVector& first,
                                           const AxisVector& second) const {
  return Derivatives{first, second};
}

double Cartesian::deviation_bound_mm(const AxisVector& /*from*/, const AxisVector& /*to*/) const {
  return 0;
}

}  // namespace kerf::kinematics
