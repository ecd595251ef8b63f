#pragma once

#include <string>

#include "machine/definition/machine_definition.hpp"

namespace kerf::machine {

/// Whether linkages of this kind have a tip whose axes are not the driven ones.
[[nodiscard]] bool has_own_tip(kinematics::Kind kind);

/// Makes what follows from the driven axes and the linkage: kinematics.joints and axes. Returns why
/// the linkage cannot be made of these axes, or nothing.
[[nodiscard]] std::string complete(MachineDefinition& machine);

}  // namespace kerf::machine
