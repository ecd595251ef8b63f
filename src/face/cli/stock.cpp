#include "base/output_file.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/run_report.hpp"
#include "face/cli/stock_order.hpp"
#include "face/cli/table_run.hpp"
#include "output/reports/stock_report.hpp"

namespace kerf::cli {
ExitStatus stock(const StockOptions& options) {
  auto table = run_on_table(options.run);
  if (!table) return fail(table.error());
  auto& [cut, facts, ready] = *table;
  ready.run = std::move(cut.run);
  const base::SourceSet& sources = ready.machine().sources();
  if (!options.report.empty()) {
    auto file = base::OutputFile::create(options.report);
    if (!file) return fail(file.error());
    (*file)->write(output::stock_report_json(facts, sources));
    if (auto committed = (*file)->commit(); !committed) return fail(committed.error());
  }
  report_diagnostics(ready, options.run.diagnostics);
  report_stock(options.run, facts, sources);
  const ExitStatus ended = exit_status_of(cut.status);
  return ended == ExitStatus::well && fails(options.run.table, facts) ? ExitStatus::findings
                                                                      : ended;
}

}  // namespace kerf::cli
