#pragma once

#include <vector>

#include "kinematics/kinematics.hpp"
#include "kinematics/settings.hpp"

namespace kerf::kinematics {

/// A carriage X over a work that turns by θ, and Z (docs/kinematics.md, X-θ-Z).
class XThetaZ final : public Kinematics {
 public:
  XThetaZ(std::vector<Joint> joints, const XThetaZOffsets& offsets);

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

  XThetaZOffsets offsets_;
};

}  // namespace kerf::kinematics
