#pragma once

#include <vector>

#include "kinematics/kinematics.hpp"

namespace kerf::kinematics {

/// Joints are the tip, whatever the axes are (docs/kinematics.md, Cartesian).
class Cartesian final : public Kinematics {
 public:
  explicit Cartesian(std::vector<Joint> joints);

  [[nodiscard]] base::AxisVector forward(const base::AxisVector& joints) const override;
  [[nodiscard]] Result<base::PathJet> along(const base::PathJet& tip,
                                            const base::AxisVector& joints) const override;
  [[nodiscard]] geometry::Vec3 tip_rates(const base::AxisVector& joints,
                                         const base::AxisVector& rates) const override;
  [[nodiscard]] double swing_bound_mm(const base::AxisVector& joints,
                                      const base::AxisVector& rates) const override;

 private:
  [[nodiscard]] Result<base::AxisVector> solve(const base::AxisVector& tip,
                                               const base::AxisVector& previous,
                                               Branch branch) const override;
};

}  // namespace kerf::kinematics
