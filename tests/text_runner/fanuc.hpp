#pragma once

#include "control/gcode/controller.hpp"
#include "machine/run/virtual_machine.hpp"

namespace kerf::test {

/// The control of a machine whose dialect is G-code.
inline control::Controller& fanuc(machine::VirtualMachine& machine) {
  return dynamic_cast<control::Controller&>(machine.control());
}

}  // namespace kerf::test
