#include "machine/definition/pattern_machine.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/decimal.hpp"
#include "drive/timer_split.hpp"
#include "math/math.hpp"
#include "motion/feed.hpp"

namespace kerf::machine {
namespace {

using base::Axis;
using base::AxisVector;
using base::JointPoint;

// Whether the driven axes are two that move the wheel over the work, the wheel and the lift.
bool has_four_motors(const MachineDefinition& machine) {
  if (machine.driven.size() != drive::kArmAxes) return false;
  if (machine.kinematics.kind == kinematics::Kind::arm) return true;
  if (machine.linkage != "cartesian-step") return false;
  const auto& axes = machine.driven;
  return axes[0].name == "X" && axes[1].name == "Y" && axes[2].name == "C" && axes[2].rotary &&
         axes[3].name == "Z";
}

}  // namespace

base::Outcome<PatternMachine> PatternMachine::of(const MachineDefinition& machine) {
  if (!has_four_motors(machine)) {
    return tl::unexpected(base::Failure{
        base::Failure::Kind::usage,
        machine.name + " has no controller for patterns: a machine of the type arm has, and one "
                       "of the type cartesian-step with the axes X Y C Z (arm4, cartesian-step)"});
  }
  PatternMachine result;
  result.definition_ = &machine;
  result.kinematics_ = machine.make_kinematics();
  for (std::size_t i = 0; i < drive::kArmAxes; ++i)
    result.steps_per_unit_[i] = machine.driven[i].steps_per_unit;
  result.x_ = *machine.axes.find('X');
  result.y_ = *machine.axes.find('Y');
  result.z_ = *machine.axes.find('Z');
  result.c_ = *machine.axes.find('C');
  return result;
}

bool PatternMachine::is_at_zero(const JointPoint& joints) const {
  constexpr double kNothing = 0.01;  // of a pulse
  for (std::size_t i = 0; i < drive::kArmAxes; ++i) {
    if (std::fabs(joints.values[i] * steps_per_unit_[i]) > kNothing) return false;
  }
  return true;
}

MachineDefinition PatternMachine::at_zero(MachineDefinition machine) {
  machine.start = {};
  machine.axes.start = machine.make_kinematics()->forward({});
  return machine;
}

JointPoint PatternMachine::joints_at(const std::array<double, drive::kArmAxes>& counts) const {
  JointPoint joints;
  for (std::size_t i = 0; i < counts.size(); ++i) joints.values[i] = counts[i] / steps_per_unit_[i];
  return joints;
}

JointPoint PatternMachine::joints_at(const drive::ArmCounts& counts) const {
  JointPoint joints;
  for (std::size_t i = 0; i < counts.values.size(); ++i)
    joints.values[i] = static_cast<double>(counts.values[i]) / steps_per_unit_[i];
  return joints;
}

drive::ArmCounts PatternMachine::counts_at(const JointPoint& joints) const {
  drive::ArmCounts counts;
  for (std::size_t i = 0; i < counts.values.size(); ++i)
    counts.values[i] = base::round_away(joints.values[i] * steps_per_unit_[i]);
  return counts;
}

std::array<drive::FastMove, 5> PatternMachine::way_to_start(drive::ArmCounts counters) const {
  const double per_mm = steps_per_unit_[index(drive::axis_of(drive::ArmAxis::z))];
  const std::int64_t up = per_mm > 0 ? 1 : -1;  // of a motor that turns the other way, up is less
  counters[drive::ArmAxis::z] *= up;
  auto moves = drive::return_to_start(
      counters, up * base::round_away(definition_->pattern.travel_z_mm * per_mm));
  for (drive::FastMove& move : moves) {
    if (move.axis == drive::ArmAxis::z) move.count *= up;
  }
  return moves;
}

std::int64_t PatternMachine::half_period_ticks(const drive::ArmCounts& from,
                                               const drive::SlowMove& triplet) const {
  const drive::ArmSettings& arm = definition_->drive.arm;
  const double speed_mm_s = definition_->pattern.cut_speed_mm_min / motion::kSecondsPerMinute;
  if (speed_mm_s == 0) return arm.half_period_ticks;
  drive::ArmCounts to = from;
  to[drive::ArmAxis::theta1] += triplet.theta1;
  to[drive::ArmAxis::theta2] += triplet.theta2;
  const AxisVector way = tip_at(to) - tip_at(from);
  return drive::speed_true_half_period(
      math::hypot(way[x_], way[y_]), speed_mm_s, arm.clock.tick_s(),
      std::max(std::abs(triplet.theta1), std::abs(triplet.theta2)), arm.half_period_ticks);
}

double PatternMachine::half_pulse_mm(const JointPoint& joints) const {
  double sum = 0;
  for (const drive::ArmAxis arm : {drive::ArmAxis::theta1, drive::ArmAxis::theta2}) {
    JointPoint low = joints;
    JointPoint high = joints;
    low[drive::axis_of(arm)] -= step(arm) / 2;
    high[drive::axis_of(arm)] += step(arm) / 2;
    const AxisVector way = kinematics_->forward(high) - kinematics_->forward(low);
    sum += math::hypot(way[x_], way[y_]) / 2;
  }
  return sum;
}

}  // namespace kerf::machine
