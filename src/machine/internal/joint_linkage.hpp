#pragma once

#include "kinematics/kinematics.hpp"
#include "motion/linkage.hpp"

namespace kerf::machine {

/// What the planner asks of a linkage, answered by the machine's kinematics.
class JointLinkage : public motion::Linkage {
 public:
  /// The kinematics must outlive this.
  explicit JointLinkage(const kinematics::Kinematics& kinematics) : kinematics_(kinematics) {}

  [[nodiscard]] std::size_t size() const override { return kinematics_.size(); }
  /// `previous` again where there are none.
  [[nodiscard]] base::AxisVector joints(const base::AxisVector& tip,
                                        const base::AxisVector& previous) const override;
  [[nodiscard]] base::PathJet along(const base::PathJet& tip,
                                    const base::AxisVector& previous) const override;
  [[nodiscard]] double deviation_mm(const base::AxisVector& from,
                                    const base::AxisVector& to) const override;

 private:
  const kinematics::Kinematics& kinematics_;
};

}  // namespace kerf::machine
