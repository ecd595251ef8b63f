#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/path_jet.hpp"
#include "base/point.hpp"
#include "geometry/vec3.hpp"
#include "kinematics/fault.hpp"
#include "kinematics/joint.hpp"

namespace kerf::kinematics {

/// The two positions of a linkage that hold the same tip: the sine of the joint that makes the
/// difference (elbow of an arm, tilt A of a head) is >= 0, or negative. Where it is 0 an arm's
/// settings say which it is.
enum class Branch : std::uint8_t { plus, minus };

/// Where the joints stand when the tool is at the tip, and back (docs/kinematics.md).
///
/// `tip` is always in the order of the program's axes, machine coordinates, tool length left out.
/// `joints` is always in the order of the machine file's axes. Both in mm and degrees, both of
/// size() entries; the rest is 0.
///
///   kind         tip                                        joints
///   cartesian    the same as joints                         any
///   x_theta_z    X Y Z                                      X θ Z
///   head_ac      X Y Z focus, A C                           X Y Z carriage, A C
///   arm          X Y Z, C heading of the wheel modulo 180   T1 forearm, T2 upper arm, T3 wheel, Z
///
/// Immutable and safe to share between threads. Nothing throws; what succeeds does not allocate.
/// Values that are not finite are the caller's bug.
class Kinematics {
 public:
  virtual ~Kinematics() = default;
  Kinematics(const Kinematics&) = delete;
  Kinematics& operator=(const Kinematics&) = delete;

  [[nodiscard]] const std::vector<Joint>& joints() const { return joints_; }
  [[nodiscard]] std::size_t size() const { return joints_.size(); }

  /// The tip of any joints, also of those beyond their limits.
  [[nodiscard]] virtual base::TipPoint forward(const base::JointPoint& joints) const = 0;

  /// The joints along a path: the branch stays that of `previous`, each rotary joint takes the turn
  /// nearest to it. Angles that the program itself gives (A and C of a head) keep the program's
  /// branch and turn. forward() of it is `tip` within 1e-9 mm and degrees (the wheel's C modulo
  /// 180). An angle that the tip leaves open stays that of `previous`.
  /// Errors: out_of_reach, limit.
  [[nodiscard]] Result<base::JointPoint> inverse(const base::TipPoint& tip,
                                                 const base::JointPoint& previous) const;

  /// The same for joints that may stand anywhere. Error: out_of_reach.
  [[nodiscard]] virtual Result<base::JointPoint> follow(const base::TipPoint& tip,
                                                        const base::JointPoint& previous) const;

  /// The joints on the branch that the caller names, every rotary joint on the turn nearest to
  /// `previous`. Precondition: has_branches(), or `branch` is plus. Errors: out_of_reach, limit.
  [[nodiscard]] Result<base::JointPoint> inverse(const base::TipPoint& tip,
                                                 const base::JointPoint& previous,
                                                 Branch branch) const;

  /// For moves from point to point, off the work: of both branches and all turns within the limits
  /// the joints with the smallest sum of turned angles from `previous`; plus when equal.
  /// Errors: out_of_reach; limit (of the branch plus) when none is within the limits.
  [[nodiscard]] Result<base::JointPoint> nearest(const base::TipPoint& tip,
                                                 const base::JointPoint& previous) const;

  /// Whether there is a branch besides plus.
  [[nodiscard]] virtual bool has_branches() const { return false; }
  [[nodiscard]] virtual Branch branch_at(const base::JointPoint& /*joints*/) const {
    return Branch::plus;
  }

  /// What the joints do while the tip moves along a path, where they stand at `joints`, which
  /// inverse() or nearest() has found for tip.value: value is `joints`, the derivatives are by the
  /// same parameter as those of the tip, analytic and finite. A tip that stands in X and Y has
  /// rates everywhere: those of the joints that hold it there are 0. Error: singular.
  [[nodiscard]] virtual Result<base::JointJet> along(const base::TipJet& tip,
                                                     const base::JointPoint& joints) const = 0;

  /// How the tip's X Y Z change, mm, while the joints change by `rates`: the derivative of
  /// forward(), linear in `rates`.
  [[nodiscard]] virtual geometry::Vec3 tip_rates(const base::JointPoint& joints,
                                                 const base::AxisVector& rates) const = 0;

  /// Upper bound, mm, of the second derivative of the tip while the joints go on at constant
  /// `rates`. Its root is a norm of them: of a sum it is at most the sum of both roots.
  [[nodiscard]] virtual double swing_bound_mm(const base::JointPoint& joints,
                                              const base::AxisVector& rates) const = 0;

  /// Upper bound, mm, of how far the tip is from the straight line between its ends while the
  /// joints move from `from` to `to` in proportion: an eighth of the larger swing of both ends.
  [[nodiscard]] double deviation_bound_mm(const base::JointPoint& from,
                                          const base::JointPoint& to) const;

  /// A sentence when these joints are so near to a singular position that small moves of the tip
  /// ask for large ones of the joints.
  [[nodiscard]] virtual std::optional<std::string> caution(const base::JointPoint& joints) const;

  /// The first joint beyond its range by more than 1e-9.
  [[nodiscard]] std::optional<Fault> beyond_limits(const base::JointPoint& joints) const;

 protected:
  /// A whole turn of each joint, after which it is in the same place; 0 for linear joints.
  using Turns = std::array<double, base::kMaxAxes>;
  Kinematics(std::vector<Joint> joints, const Turns& turns_deg);

 private:
  [[nodiscard]] virtual Result<base::JointPoint> solve(const base::TipPoint& tip,
                                                       const base::JointPoint& previous,
                                                       Branch branch) const = 0;

  [[nodiscard]] Result<base::JointPoint> within_limits(Result<base::JointPoint> joints) const;
  [[nodiscard]] Result<base::JointPoint> in_range(const base::TipPoint& tip,
                                                  const base::JointPoint& previous,
                                                  Branch branch) const;
  [[nodiscard]] double turned_deg(const base::JointPoint& from, const base::JointPoint& to) const;

  std::vector<Joint> joints_;
  Turns turns_deg_;
};

}  // namespace kerf::kinematics
