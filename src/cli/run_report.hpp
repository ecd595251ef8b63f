#pragma once

#include "cli/commands.hpp"
#include "machine/virtual_machine.hpp"

namespace kerf::cli {

/// What a run has to say besides its results, on standard error: warnings, the alarm, the budget.
void report_diagnostics(machine::VirtualMachine& machine, DiagnosticFormat format);

}  // namespace kerf::cli
