#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/program_text.hpp"
#include "control/core/memory.hpp"
#include "machine/definition/machine_definition.hpp"
#include "machine/dialect/signals.hpp"
#include "machine/panel/live_machine.hpp"
#include "machine/panel/panel.hpp"
#include "machine/run/breakpoint.hpp"

namespace kerf::machine {

/// All that a run begins with: made from it again, a machine does the same again.
struct RunStart {
  MachineDefinition definition;  ///< its start is where the axes stand
  control::Memory memory;
  LiveMachine::Settings settings;
  std::string dialect;
  PanelSettings panel{};
  std::optional<base::ProgramText> program{};
  std::vector<Breakpoint> breakpoints{};
  base::AxisVector shift{};  ///< of G92
  Signals signals{};
  std::string printed{};  ///< the end of it
  std::uint64_t printed_bytes = 0;
};

}  // namespace kerf::machine
