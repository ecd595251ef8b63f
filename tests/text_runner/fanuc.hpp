#pragma once

#include "control/gcode/gcode_control.hpp"
#include "machine/run/batch_run.hpp"

namespace kerf::test {

/// The control of a machine whose dialect is G-code.
inline control::GcodeControl& fanuc(machine::BatchRun& machine) {
  return dynamic_cast<control::GcodeControl&>(machine.control());
}

}  // namespace kerf::test
