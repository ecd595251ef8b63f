#include "base/output_file.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/ready_run.hpp"
#include "face/cli/run_report.hpp"
#include "output/reports/time_report.hpp"

namespace kerf::cli {
ExitStatus time(const TimeOptions& options) {
  auto ready = make_ready(options.run);
  if (!ready) return fail(ready.error());
  machine::BatchRun& machine = ready->machine();
  const machine::MachineDefinition& definition = machine.definition();
  output::TimeReport times(definition.axes, definition.interpolator.period_s);
  machine.add_point_sink(times);
  machine.observe_blocks(
      [&times](base::FileId file, std::uint32_t line) { times.line_begins(file, line); });
  const auto status = ready->run->go();
  const output::RunFacts facts = facts_of(*ready);
  auto file = base::OutputFile::create("-");
  if (!file) return fail(file.error());
  (*file)->write(options.format == "json" ? times.json(facts, machine.sources())
                                          : times.text(facts, machine.sources()));
  if (auto committed = (*file)->commit(); !committed) return fail(committed.error());
  report_diagnostics(*ready, options.run.diagnostics);
  return exit_status_of(status);
}

}  // namespace kerf::cli
