#pragma once

#include <vector>

#include "machine/definition/machine_definition.hpp"
#include "stock/cutting/work_frame.hpp"

namespace kerf::machine {

/// The rotary axes that turn the work of a machine, the one that carries the others first: of a
/// Cartesian mill A, B, C about X, Y, Z, in the order of the file, through the points of its
/// kinematics. Machines whose programs say where the tip is in the work have none.
[[nodiscard]] std::vector<stock::WorkTurn> work_turns(const MachineDefinition& machine);

}  // namespace kerf::machine
