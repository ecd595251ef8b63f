#include <cstdio>

#include "base/output_file.hpp"
#include "cli/commands.hpp"
#include "cli/failure.hpp"
#include "cli/machine_setup.hpp"
#include "output/diagnostic_text.hpp"
#include "output/time_report.hpp"

namespace kerf::cli {
namespace {

using machine::VirtualMachine;

void report(const VirtualMachine& machine, DiagnosticFormat format) {
  for (const auto* diagnostic : {&machine.alarm(), &machine.notice()}) {
    if (!*diagnostic) continue;
    const std::string text = format == DiagnosticFormat::json
                                 ? output::diagnostic_json(**diagnostic, machine.sources())
                                 : output::diagnostic_text(**diagnostic, machine.sources());
    std::fwrite(text.data(), 1, text.size(), stderr);
  }
}

}  // namespace

ExitStatus time(const TimeOptions& options) {
  auto ready = make_ready(options.run);
  if (!ready) return fail(ready.error());
  VirtualMachine& machine = *ready->machine;
  const machine::MachineDefinition& definition = machine.definition();
  output::TimeReport times(definition.axes, definition.interpolator.period_s);
  machine.add_point_sink(times);
  const auto status = machine.run_to_end({options.run.max_seconds, options.run.max_motions, 0});
  auto file = base::OutputFile::create("-");
  if (!file) return fail(file.error());
  (*file)->write(options.format == "json" ? times.json(machine) : times.text(machine));
  if (auto committed = (*file)->commit(); !committed) return fail(committed.error());
  report(machine, options.run.diagnostics);
  return exit_status_of(status);
}

}  // namespace kerf::cli
