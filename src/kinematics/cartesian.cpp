#include "kinematics/internal/cartesian.hpp"

#include <cstddef>
#include <utility>

#include "kinematics/internal/vocabulary.hpp"

namespace kerf::kinematics {

// Also a rotary axis keeps the program's turn: nothing of it is computed.
Cartesian::Cartesian(std::vector<Joint> joints) : Kinematics(std::move(joints), Turns{}) {}

TipPoint Cartesian::forward(const JointPoint& joints) const { return TipPoint(joints.numbers()); }

Result<JointPoint> Cartesian::solve(const TipPoint& tip, const JointPoint& /*previous*/,
                                    Branch /*branch*/) const {
  return JointPoint(tip.numbers());
}

Result<JointJet> Cartesian::along(const TipJet& tip, const JointPoint& joints) const {
  return JointJet{joints, tip.first, tip.second, tip.third};
}

geometry::Vec3 Cartesian::tip_rates(const JointPoint& /*joints*/, const AxisVector& rates) const {
  const auto rate_of = [&](const char* name) {
    for (std::size_t m = 0; m < size(); ++m) {
      if (this->joints()[m].name == name) return rates.values[m];
    }
    return 0.0;
  };
  return {rate_of("X"), rate_of("Y"), rate_of("Z")};
}

double Cartesian::swing_bound_mm(const JointPoint& /*joints*/, const AxisVector& /*rates*/) const {
  return 0;
}

}  // namespace kerf::kinematics
