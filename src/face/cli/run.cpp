#include <cstdio>

#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/operator_input.hpp"
#include "face/cli/outputs.hpp"
#include "face/cli/pattern_run.hpp"
#include "face/cli/progress.hpp"
#include "face/cli/ready_run.hpp"
#include "face/cli/run_report.hpp"
#include "face/cli/stock_order.hpp"
#include "face/cli/stock_table.hpp"
#include "machine/definition/state_file.hpp"
#include "output/reports/stock_report.hpp"
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

namespace {

/// Makes a run that is ready, with all its outputs. `table`: what lies there; null: nothing.
ExitStatus make(const RunOptions& options, const ReadyRun& ready, const TableRun* table) {
  BatchRun& machine = ready.machine();
  Outputs outputs(options, ready);
  if (table != nullptr) {
    outputs.tell_stock(output::checked_stock(table->facts, table->cut.run->machine().sources()));
    for (const std::string& input : table->set_up.files()) outputs.keep_from(input);
  }
  if (auto opened = outputs.open(); !opened) return fail(opened.error());
  const Status status = run_showing_progress(*ready.run);
  if (auto committed = outputs.commit(); !committed) return fail(committed.error());
  if (!options.state.empty()) {
    if (auto written = machine::write_state(options.state, machine.memory()); !written)
      return fail(written.error());
  }
  report(options, ready, outputs);
  const ExitStatus made = outputs.fails() && exit_status_of(status) == ExitStatus::well
                              ? ExitStatus::findings
                              : exit_status_of(status);
  if (table == nullptr) return made;
  report_stock(options, table->facts, table->cut.run->machine().sources());
  const bool is_well = made == ExitStatus::well;
  return is_well && fails(table->set_up, table->facts) ? ExitStatus::findings : made;
}

}  // namespace

ExitStatus run(const RunOptions& options) {
  const auto on_table = has_table(options.table);
  if (!on_table) return fail(on_table.error());
  if (is_pattern(options.dialect, options.program))
    return *on_table
               ? fail(base::Failure{base::Failure::Kind::usage, "--stock: a pattern cuts no stock"})
               : run_pattern(options);
  if (*on_table) {
    const auto table = run_on_table(options);
    return table ? make(options, table->ready, &*table) : fail(table.error());
  }
  auto ready = make_ready(options);
  if (!ready) return fail(ready.error());
  ready->machine().set_input(operator_input);
  return make(options, *ready, nullptr);
}

}  // namespace kerf::cli
