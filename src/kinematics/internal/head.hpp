#pragma once

#include <vector>

#include "kinematics/kinematics.hpp"
#include "kinematics/settings.hpp"

namespace kerf::kinematics {

/// A laser head that tilts by A and turns by C below a carriage X Y Z; the tip is the focus
/// (docs/kinematics.md, Head).
class Head final : public Kinematics {
 public:
  Head(std::vector<Joint> joints, const HeadRadii& radii);

  [[nodiscard]] base::TipPoint forward(const base::JointPoint& joints) const override;
  [[nodiscard]] Result<base::JointPoint> follow(const base::TipPoint& tip,
                                                const base::JointPoint& previous) const override;
  [[nodiscard]] bool has_branches() const override { return true; }
  [[nodiscard]] Branch branch_at(const base::JointPoint& joints) const override;
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
  [[nodiscard]] base::AxisVector carriage_offset(double a_deg, double c_deg) const;

  HeadRadii radii_;
};

}  // namespace kerf::kinematics
