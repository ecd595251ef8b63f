#include "machine/definition/internal/program_axes.hpp"

#include <cmath>

#include "base/decimal.hpp"
#include "kinematics/make.hpp"

namespace kerf::machine {
namespace {

using kinematics::Joint;
using kinematics::Kind;
using kinematics::Kinematics;
using motion::AxisConfig;

constexpr std::size_t kWheel = 2;  // of the driven axes of an arm
constexpr std::size_t kLift = 3;
constexpr std::size_t kXThetaZCarriage = 0;  // of X-θ-Z
constexpr std::size_t kXThetaZWork = 1;
constexpr std::size_t kXThetaZLift = 2;

std::vector<Joint> joints_of(const MachineDefinition& machine) {
  std::vector<Joint> joints;
  for (const DrivenAxis& axis : machine.driven) {
    Joint joint{axis.name, axis.rotary};
    if (machine.kinematics.kind != Kind::cartesian) {
      joint.low = axis.travel_low;
      joint.high = axis.travel_high;
    }
    joints.push_back(std::move(joint));
  }
  return joints;
}

AxisConfig axis_with_rates(char letter, const DrivenAxis& axis) {
  AxisConfig config;
  config.letter = letter;
  config.rotary = axis.rotary;
  config.diameter = axis.diameter;
  config.rapid_per_min = axis.velocity_per_min;
  config.acceleration = axis.acceleration;
  config.jerk = axis.jerk;
  return config;
}

AxisConfig axis_of_tip(char letter, const TipRates& rates) {
  AxisConfig config;
  config.letter = letter;
  config.rapid_per_min = rates.velocity_per_min;
  config.acceleration = rates.acceleration;
  return config;
}

// A program's axis that is a driven one: the tip of a head moves its linear axes otherwise.
AxisConfig same_axis(Kind kind, const DrivenAxis& axis) {
  AxisConfig config = axis_with_rates(axis.name[0], axis);
  config.reference = axis.reference;
  if (kind == Kind::head_ac && !axis.rotary) return config;
  if (!std::isfinite(axis.travel_low) || !std::isfinite(axis.travel_high)) return config;
  config.travel_min = axis.travel_low;
  config.travel_max = axis.travel_high;
  return config;
}

std::vector<AxisConfig> tip_axes(const MachineDefinition& machine) {
  const bool arm = machine.kinematics.kind == Kind::arm;
  std::vector<AxisConfig> axes{axis_of_tip('X', machine.tip), axis_of_tip('Y', machine.tip),
                               axis_with_rates('Z', machine.driven[arm ? kLift : kXThetaZLift])};
  if (arm) axes.push_back(axis_with_rates('C', machine.driven[kWheel]));
  return axes;
}

base::TipPoint tidied(base::TipPoint point) {
  for (double& value : point.values) value = base::tidy(value);
  return point;
}

base::JointPoint reference_of(const MachineDefinition& machine, std::size_t point) {
  base::JointPoint joints;
  for (std::size_t i = 0; i < machine.driven.size(); ++i) {
    joints.values[i] = machine.driven[i].reference[point];
  }
  return joints;
}

void refer(std::vector<AxisConfig>& axes, const MachineDefinition& machine,
           const Kinematics& linkage) {
  for (std::size_t point = 0; point < DrivenAxis{}.reference.size(); ++point) {
    const base::TipPoint tip = tidied(linkage.forward(reference_of(machine, point)));
    for (std::size_t i = 0; i < axes.size(); ++i) axes[i].reference[point] = tip.values[i];
  }
}

std::vector<AxisConfig> program_axes(const MachineDefinition& machine, const Kinematics& linkage) {
  std::vector<AxisConfig> axes;
  if (has_own_tip(machine.kinematics.kind)) {
    axes = tip_axes(machine);
    refer(axes, machine, linkage);
  } else {
    for (const DrivenAxis& axis : machine.driven) {
      axes.push_back(same_axis(machine.kinematics.kind, axis));
    }
  }
  return axes;
}

// Axes that a program names stand at 0 in its sense: of a head the focus does, and its carriage
// where that is so.
void start(MachineDefinition& machine, const Kinematics& linkage) {
  machine.start = {};
  machine.axes.start = {};
  if (has_own_tip(machine.kinematics.kind)) {
    machine.axes.start = tidied(linkage.forward(machine.start));
  } else if (const auto joints = linkage.follow(machine.axes.start, {})) {
    machine.start = *joints;
  }
}

// A lathe's usual feed mode needs one.
constexpr double kStandingLathe_rpm = 1000;

}  // namespace

bool has_own_tip(Kind kind) { return kind == Kind::x_theta_z || kind == Kind::arm; }

std::string complete(MachineDefinition& machine) {
  machine.kinematics.joints = joints_of(machine);
  const auto linkage = kinematics::make_kinematics(machine.kinematics);
  if (!linkage) return linkage.error().message;
  machine.axes.axes = program_axes(machine, **linkage);
  machine.axes.linked = machine.kinematics.kind != Kind::cartesian;
  machine.axes.turning_work.reset();
  if (machine.tip.rapid == RapidWay::joint)
    machine.axes.turning_work = {machine.driven[kXThetaZCarriage].velocity_per_min,
                                 machine.driven[kXThetaZWork].velocity_per_min};
  machine.axes.beam = machine.drive.laser.fitted();
  machine.axes.standing_rpm = machine.dialect == kLatheDialect ? kStandingLathe_rpm : 0;
  for (const control::SpindleSettings& spindle : machine.parameters.machine_codes.spindles)
    machine.axes.spindle_acceleration[index(spindle.name)] = spindle.acceleration_rpm_s;
  start(machine, **linkage);
  return {};
}

}  // namespace kerf::machine
