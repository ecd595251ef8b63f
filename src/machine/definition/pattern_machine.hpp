#pragma once

#include <memory>

#include "base/result.hpp"
#include "drive/arm_axis.hpp"
#include "drive/return_to_start.hpp"
#include "drive/slow_move.hpp"
#include "kinematics/kinematics.hpp"
#include "machine/definition/machine_definition.hpp"

namespace kerf::machine {

/// A machine as a pattern sees it: four motors that count pulses, and where the tool is then. The
/// motors are the driven axes in the order of the machine file: the arm's T1 T2 T3 Z, or X Y, a
/// wheel and a lift. Immutable.
class PatternMachine {
 public:
  /// Failure (usage): no controller of patterns drives a machine of these axes. The definition must
  /// outlive the result.
  [[nodiscard]] static base::Outcome<PatternMachine> of(const MachineDefinition& machine);

  /// Every motor stands where its counter is 0, to a hundredth of a pulse.
  [[nodiscard]] bool is_at_zero(const base::JointPoint& joints) const;
  /// The machine with its start there.
  [[nodiscard]] static MachineDefinition at_zero(MachineDefinition machine);

  [[nodiscard]] const MachineDefinition& definition() const { return *definition_; }
  [[nodiscard]] const kinematics::Kinematics& kinematics() const { return *kinematics_; }

  /// Where the joints stand after counts, which may have a fraction of a pulse.
  [[nodiscard]] base::JointPoint joints_at(const std::array<double, drive::kArmAxes>& counts) const;
  [[nodiscard]] base::JointPoint joints_at(const drive::ArmCounts& counts) const;
  /// The counts nearest to joints: each is rounded by itself, ties away from zero.
  [[nodiscard]] drive::ArmCounts counts_at(const base::JointPoint& joints) const;
  [[nodiscard]] base::TipPoint tip_at(const drive::ArmCounts& counts) const {
    return kinematics_->forward(joints_at(counts));
  }
  /// Of one pulse, degrees, mm; its sign is that of the motor.
  [[nodiscard]] double step(drive::ArmAxis axis) const {
    return 1 / steps_per_unit_[index(drive::axis_of(axis))];
  }

  /// The fast moves that bring every counter to 0: drive::return_to_start(), clear of the work.
  [[nodiscard]] std::array<drive::FastMove, 5> way_to_start(drive::ArmCounts counters) const;

  /// Ticks with which the arms make a triplet from these counts: those of the drive, or more, so
  /// that the tip goes at pattern.cut_speed.
  [[nodiscard]] std::int64_t half_period_ticks(const drive::ArmCounts& from,
                                               const drive::SlowMove& triplet) const;

  // Of the program's axes.
  [[nodiscard]] base::Axis x() const { return x_; }
  [[nodiscard]] base::Axis y() const { return y_; }
  [[nodiscard]] base::Axis z() const { return z_; }
  [[nodiscard]] base::Axis c() const { return c_; }

  /// Bound, mm, of how far the tip leaves its place in X and Y when both arms are off by half a
  /// pulse.
  [[nodiscard]] double half_pulse_mm(const base::JointPoint& joints) const;

 private:
  PatternMachine() = default;

  const MachineDefinition* definition_ = nullptr;
  std::shared_ptr<const kinematics::Kinematics> kinematics_;  // shared: the value copies
  std::array<double, drive::kArmAxes> steps_per_unit_{};
  base::Axis x_{}, y_{}, z_{}, c_{};
};

}  // namespace kerf::machine
