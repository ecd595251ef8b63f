#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/program_text.hpp"
#include "control/core/memory.hpp"
#include "machine/definition/machine_definition.hpp"
#include "machine/run/budget.hpp"
#include "machine/run/known_skips.hpp"
#include "machine/run/machine.hpp"
#include "machine/run/skip_contacts.hpp"

namespace kerf::job {

/// A variable as it is set before the program starts.
struct InitialVariable {
  std::string name;  ///< in the program's language: "#100"
  double value = 0;
  std::string said;  ///< what messages call the setting, as its author wrote it
};

/// A run as a value: which program, on which machine, from which state, and how long at most. The
/// same job is the same run, however often it is made.
struct Job {
  machine::MachineDefinition definition;
  control::Memory memory;
  machine::Machine::Settings settings{};
  base::ProgramText program{};
  std::vector<InitialVariable> variables{};
  /// What the operator enters for INPUT, by the number of the line from 0; nothing: there is no
  /// more. Empty: nobody enters anything.
  std::function<std::optional<std::string>(std::size_t)> input{};
  std::vector<machine::SkipContact> contacts{};
  /// What probes met when this job was run with its stock; contacts count more.
  machine::Skips skips{};
  std::vector<double> interrupt_at_s{};  ///< signals of a macro interrupt (M96), times of the run
  bool behind_alarms = false;            ///< BatchRun::search_alarms()
  machine::Budget budget{};
};

}  // namespace kerf::job
