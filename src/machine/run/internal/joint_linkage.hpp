#pragma once

#include "kinematics/kinematics.hpp"
#include "planner/linkage.hpp"

namespace kerf::machine {

/// What the planner asks of a linkage, answered by the machine's kinematics.
class JointLinkage : public planner::Linkage {
 public:
  /// The kinematics must outlive this.
  JointLinkage(const kinematics::Kinematics& kinematics, const base::JointPoint& start)
      : kinematics_(kinematics), start_(start) {}

  [[nodiscard]] std::size_t size() const override { return kinematics_.size(); }
  [[nodiscard]] base::JointPoint start() const override { return start_; }
  /// Limits of joints are not looked at: rounded corners may leave them by their tolerance.
  [[nodiscard]] base::JointPoint joints(const base::TipPoint& tip,
                                        const base::JointPoint& previous) const override;
  [[nodiscard]] std::optional<base::JointJet> along(const base::TipJet& tip,
                                                    const base::JointPoint& joints) const override;
  [[nodiscard]] double tip_way_mm(const base::JointPoint& joints,
                                  const base::AxisVector& way) const override;
  [[nodiscard]] double swing_mm(const base::JointPoint& joints,
                                const base::AxisVector& rates) const override;

 private:
  const kinematics::Kinematics& kinematics_;
  base::JointPoint start_;
};

}  // namespace kerf::machine
