#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/kinematics.hpp"
#include "kinematics/settings.hpp"

namespace kerf::kinematics {

/// Two horizontal links with a wheel at the end that turns about the vertical, and a lift Z
/// (docs/kinematics.md, Arm).
class Arm final : public Kinematics {
 public:
  Arm(std::vector<Joint> joints, const ArmLinks& links);

  [[nodiscard]] base::TipPoint forward(const base::JointPoint& joints) const override;
  [[nodiscard]] bool has_branches() const override { return true; }
  [[nodiscard]] Branch branch_at(const base::JointPoint& joints) const override;
  [[nodiscard]] Result<base::JointJet> along(const base::TipJet& tip,
                                             const base::JointPoint& joints) const override;
  [[nodiscard]] geometry::Vec3 tip_rates(const base::JointPoint& joints,
                                         const base::AxisVector& rates) const override;
  [[nodiscard]] double swing_bound_mm(const base::JointPoint& joints,
                                      const base::AxisVector& rates) const override;
  [[nodiscard]] std::optional<std::string> caution(const base::JointPoint& joints) const override;

 private:
  /// Angles of the links, degrees: of the upper arm and the forearm from +X, and of the elbow.
  struct Pose {
    double upper_deg = 0;
    double forearm_deg = 0;
    double elbow_deg = 0;  ///< forearm minus upper arm
  };

  [[nodiscard]] Result<base::JointPoint> solve(const base::TipPoint& tip,
                                               const base::JointPoint& previous,
                                               Branch branch) const override;
  [[nodiscard]] static base::JointJet lifting(const base::TipJet& tip,
                                              const base::JointPoint& joints);
  [[nodiscard]] Pose pose_at(const base::AxisVector& joints) const;
  [[nodiscard]] std::optional<Fault> out_of_reach(const base::TipPoint& tip,
                                                  double radius_mm) const;
  [[nodiscard]] std::string in_words(const Pose& pose) const;

  ArmLinks links_;
};

}  // namespace kerf::kinematics
