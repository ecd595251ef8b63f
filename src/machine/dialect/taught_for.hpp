#pragma once

#include "base/decimal.hpp"
#include "control/teach/taught_moves.hpp"
#include "machine/definition/machine_definition.hpp"

namespace kerf::machine {

/// What a machine says of itself to whoever runs or writes taught points for it.
[[nodiscard]] inline control::TaughtFor taught_for(const MachineDefinition& machine) {
  control::TaughtFor self;
  self.period_ms = base::tidy(machine.interpolator.period_s * 1000);
  if (machine.kinematics.kind == kinematics::Kind::head_ac)
    self.radii = {machine.kinematics.head.r_a_mm, machine.kinematics.head.r_c_mm};
  self.has_laser = machine.drive.laser.fitted();
  self.checks_strokes = machine.parameters.stroke_check && !machine.axes.linked;
  return self;
}

}  // namespace kerf::machine
