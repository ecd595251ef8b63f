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

  [[nodiscard]] base::AxisVector forward(const base::AxisVector& joints) const override;
  [[nodiscard]] Result<base::AxisVector> follow(const base::AxisVector& tip,
                                                const base::AxisVector& previous) const override;
  [[nodiscard]] bool has_branches() const override { return true; }
  [[nodiscard]] Branch branch_at(const base::AxisVector& joints) const override;
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
  [[nodiscard]] base::AxisVector carriage_offset(double a_deg, double c_deg) const;

  HeadRadii radii_;
};

}  // namespace kerf::kinematics
