#include "face/cli/run_report.hpp"

#include <cstdio>

#include "output/writing/diagnostic_text.hpp"
#include "output/writing/drive_alarm.hpp"

namespace kerf::cli {

void tell(const base::Diagnostic& diagnostic, const base::SourceSet& sources,
          DiagnosticFormat format) {
  const std::string text = format == DiagnosticFormat::json
                               ? output::diagnostic_json(diagnostic, sources)
                               : output::diagnostic_text(diagnostic, sources);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void report_diagnostics(const ReadyRun& ready, DiagnosticFormat format) {
  machine::BatchRun& machine = ready.machine();
  const auto say = [&](const base::Diagnostic& diagnostic) {
    tell(diagnostic, machine.sources(), format);
  };
  if (ready.hint) say(output::at_line(*ready.hint, machine.sources()));
  for (const base::Diagnostic& warning : machine.control().warnings()) say(warning);
  for (const base::Diagnostic& warning : machine.warnings())
    say(output::at_line(warning, machine.sources()));
  if (const auto alarm = ready.alarm()) say(*alarm);
  if (machine.notice()) say(*machine.notice());
}

}  // namespace kerf::cli
