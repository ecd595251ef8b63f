#pragma once

#include <string>

#include "machine/run/batch_run.hpp"
#include "output/reports/run_facts.hpp"
#include "output/writing/drive_fault.hpp"

namespace kerf::job {

/// What the machine's run came to, for reports.
[[nodiscard]] output::RunFacts facts_of(machine::BatchRun& machine);

/// What a person calls the program of the machine: its name, else that of its file.
[[nodiscard]] std::string title_of(const machine::BatchRun& machine);
/// The same of the program that its motions come from; empty: motion records do not say.
[[nodiscard]] std::string source_of(const machine::BatchRun& machine);

/// Has the machine end in the alarm of whoever cannot follow it, at the line of the motion that was
/// under way. The machine must outlive what this returns.
[[nodiscard]] output::DriveFault alarm_of(machine::BatchRun& machine);

}  // namespace kerf::job
