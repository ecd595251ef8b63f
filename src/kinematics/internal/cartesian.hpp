#pragma once

#include <vector>

#include "kinematics/kinematics.hpp"

namespace kerf::kinematics {

/// Joints are the tip, whatever the axes are (docs/kinematics.md, Cartesian).
class Cartesian final : public Kinematics {
 public:
  explicit Cartesian(std::vector<Joint> joints);

  [[nodiscard]] base::TipPoint forward(const base::JointPoint& joints) const override;
  [[nodiscard]] Result<base::JointJet> along(const base::TipJet& tip,
                                             const base::JointPoint& joints) const override;
  [[nodiscard]] geometry::Vec3 tip_rates(const base::JointPoint& joints,
                                         const base::AxisVector& rates) const override;
  [[nodiscard]] double swing_bound_mm(const base::JointPoint& joints,
                                      const base::AxisVector& rates) const override;

 private:
  [[nodiscard]] Result<base::JointPoint> solve(const base::TipPoint& tip,
                                               const base::JointPoint& previous,
                                               Branch branch) const override;
};

}  // namespace kerf::kinematics
