#include <cstdio>

#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/operator_input.hpp"
#include "face/cli/outputs.hpp"
#include "face/cli/pattern_run.hpp"
#include "face/cli/progress.hpp"
#include "face/cli/ready_run.hpp"
#include "face/cli/run_report.hpp"
#include "machine/definition/state_file.hpp"
#include "output/reports/summary.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::cli {
namespace {

using machine::BatchRun;
using Status = machine::RunStatus;

void tell(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

void report(const RunOptions& options, const ReadyRun& ready, const Outputs& outputs) {
  report_diagnostics(ready, options.diagnostics);
  if (options.diagnostics == DiagnosticFormat::json) return;
  tell(output::summary_text(facts_of(ready)));
  if (!ready.choice.why.empty()) tell("  " + output::printable(ready.choice.why) + "\n");
  tell(outputs.remarks());
  for (const std::string& path : outputs.written())
    tell("  wrote " + output::printable(path) + "\n");
}

Status run_showing_progress(job::Run& run) {
  BatchRun& machine = run.machine();
  Progress progress;
  if (progress.wanted()) {
    machine.observe_progress([&] {
      const base::Place place = machine.control().standing_at();
      const bool in_main = place.file == base::FileId{0};
      if (!in_main) return;
      progress.show(place.line_start, machine.sources()[place.file].size(),
                    machine.statistics().motions());
    });
  }
  const Status status = run.go();
  machine.observe_progress(nullptr);
  return status;
}

}  // namespace

ExitStatus run(const RunOptions& options) {
  if (is_pattern(options.dialect, options.program)) return run_pattern(options);
  auto ready = make_ready(options);
  if (!ready) return fail(ready.error());
  BatchRun& machine = ready->machine();
  machine.set_input(operator_input);
  Outputs outputs(options, *ready);
  if (auto opened = outputs.open(); !opened) return fail(opened.error());
  const Status status = run_showing_progress(*ready->run);
  if (auto committed = outputs.commit(); !committed) return fail(committed.error());
  if (!options.state.empty()) {
    if (auto written = machine::write_state(options.state, machine.memory()); !written)
      return fail(written.error());
  }
  report(options, *ready, outputs);
  return exit_status_of(status);
}

}  // namespace kerf::cli
