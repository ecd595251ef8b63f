#include "face/cli/run_report.hpp"

#include <cstdio>

#include "output/writing/diagnostic_text.hpp"
#include "output/writing/drive_alarm.hpp"

namespace kerf::cli {

void report_diagnostics(const ReadyRun& ready, DiagnosticFormat format) {
  machine::BatchRun& machine = ready.machine();
  const auto tell = [&](const base::Diagnostic& diagnostic) {
    const std::string text = format == DiagnosticFormat::json
                                 ? output::diagnostic_json(diagnostic, machine.sources())
                                 : output::diagnostic_text(diagnostic, machine.sources());
    std::fwrite(text.data(), 1, text.size(), stderr);
  };
  if (ready.hint) tell(output::at_line(*ready.hint, machine.sources()));
  for (const base::Diagnostic& warning : machine.control().warnings()) tell(warning);
  for (const base::Diagnostic& warning : machine.warnings())
    tell(output::at_line(warning, machine.sources()));
  if (const auto alarm = ready.alarm()) tell(*alarm);
  if (machine.notice()) tell(*machine.notice());
}

}  // namespace kerf::cli
