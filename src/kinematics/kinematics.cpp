#include "kinematics/kinematics.hpp"

#include <cassert>
#include <cmath>
#include <utility>

#include "kinematics/internal/shown.hpp"
#include "kinematics/internal/vocabulary.hpp"

namespace kerf::kinematics {
namespace {

constexpr double kRangeTolerance = 1e-9;  // mm, degrees: rounding of the inverse
constexpr double kEqualTurns_deg = 1e-9;

Axis axis(std::size_t i) { return Axis{static_cast<std::uint8_t>(i)}; }

bool within(const Joint& joint, double value) {
  return value >= joint.low - kRangeTolerance && value <= joint.high + kRangeTolerance;
}

Fault limit_fault(const Joint& joint, Axis which, double value) {
  const double limit = value < joint.low ? joint.low : joint.high;
  const char* const unit = joint.rotary ? " degrees" : " mm";
  return {Fault::Kind::limit,
          joint.name + " would stand at " + shown(value) + unit + ", beyond its limit of " +
              shown(limit) + unit,
          which, value, limit};
}

/// `value` or, when it is beyond an end of the range, the turn of it next to that end within the
/// range. `value` when there is none.
double turned_into_range(const Joint& joint, double value, double turn_deg) {
  if (turn_deg == 0 || within(joint, value)) return value;
  const double other =
      value < joint.low
          ? value + turn_deg * std::ceil((joint.low - kRangeTolerance - value) / turn_deg)
          : value - turn_deg * std::ceil((value - joint.high - kRangeTolerance) / turn_deg);
  return within(joint, other) ? other : value;
}

}  // namespace

Kinematics::Kinematics(std::vector<Joint> joints, const Turns& turns_deg)
    : joints_(std::move(joints)), turns_deg_(turns_deg) {}

Result<JointPoint> Kinematics::inverse(const TipPoint& tip, const JointPoint& previous) const {
  return within_limits(follow(tip, previous));
}

Result<JointPoint> Kinematics::inverse(const TipPoint& tip, const JointPoint& previous,
                                       Branch branch) const {
  assert(branch == Branch::plus || has_branches());
  return within_limits(solve(tip, previous, branch));
}

Result<JointPoint> Kinematics::nearest(const TipPoint& tip, const JointPoint& previous) const {
  auto plus = in_range(tip, previous, Branch::plus);
  if (!has_branches()) return plus;
  auto minus = in_range(tip, previous, Branch::minus);
  if (!minus) return plus;
  if (!plus) return minus;
  const bool minus_is_nearer =
      turned_deg(previous, *minus) < turned_deg(previous, *plus) - kEqualTurns_deg;
  return minus_is_nearer ? minus : plus;
}

double Kinematics::deviation_bound_mm(const JointPoint& from, const JointPoint& to) const {
  const AxisVector way = to - from;
  return std::max(swing_bound_mm(from, way), swing_bound_mm(to, way)) / 8;
}

std::optional<std::string> Kinematics::caution(const JointPoint& /*joints*/) const { return {}; }

std::optional<Fault> Kinematics::beyond_limits(const JointPoint& joints) const {
  for (std::size_t i = 0; i < size(); ++i) {
    const double value = joints[axis(i)];
    if (!within(joints_[i], value)) return limit_fault(joints_[i], axis(i), value);
  }
  return {};
}

Result<JointPoint> Kinematics::follow(const TipPoint& tip, const JointPoint& previous) const {
  return solve(tip, previous, branch_at(previous));
}

Result<JointPoint> Kinematics::within_limits(Result<JointPoint> joints) const {
  if (!joints) return joints;
  if (auto fault = beyond_limits(*joints)) return base::unexpected(*std::move(fault));
  return joints;
}

Result<JointPoint> Kinematics::in_range(const TipPoint& tip, const JointPoint& previous,
                                        Branch branch) const {
  auto joints = solve(tip, previous, branch);
  if (!joints) return joints;
  for (std::size_t i = 0; i < size(); ++i) {
    double& value = (*joints)[axis(i)];
    value = turned_into_range(joints_[i], value, turns_deg_[i]);
  }
  return within_limits(std::move(joints));
}

double Kinematics::turned_deg(const JointPoint& from, const JointPoint& to) const {
  double sum = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    if (turns_deg_[i] != 0) sum += std::fabs(to[axis(i)] - from[axis(i)]);
  }
  return sum;
}

}  // namespace kerf::kinematics
