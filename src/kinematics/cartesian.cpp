#include "kinematics/internal/cartesian.hpp"

#include <cstddef>
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

geometry::Vec3 Cartesian::tip_rates(const AxisVector& /*joints*/, const AxisVector& rates) const {
  const auto rate_of = [&](const char* name) {
    for (std::size_t m = 0; m < size(); ++m) {
      if (this->joints()[m].name == name) return rates.values[m];
    }
    return 0.0;
  };
  return {rate_of("X"), rate_of("Y"), rate_of("Z")};
}

double Cartesian::swing_bound_mm(const AxisVector& /*joints*/, const AxisVector& /*rates*/) const {
  return 0;
}

}  // namespace kerf::kinematics
