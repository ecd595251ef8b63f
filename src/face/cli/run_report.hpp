#pragma once

#include "face/cli/commands.hpp"
#include "face/cli/ready_run.hpp"

namespace kerf::cli {

/// Says one thing on standard error.
void tell(const base::Diagnostic& diagnostic, const base::SourceSet& sources,
          DiagnosticFormat format);

/// What a run has to say besides its results, on standard error: warnings, the alarm, the budget.
void report_diagnostics(const ReadyRun& ready, DiagnosticFormat format);

}  // namespace kerf::cli
