#include <cstdio>

#include "base/output_file.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/ready_run.hpp"
#include "face/cli/run_report.hpp"
#include "face/cli/stock_order.hpp"
#include "job/facts_of_stock.hpp"
#include "job/stock_run.hpp"
#include "output/reports/stock_report.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::cli {
namespace {

void tell_findings(const StockOptions& options, const output::StockFacts& facts,
                   const base::SourceSet& sources) {
  if (options.run.diagnostics != DiagnosticFormat::json) {
    const std::string text = output::stock_report_text(facts, sources);
    std::fwrite(text.data(), 1, text.size(), stderr);
    return;
  }
  for (const output::StockFacts::Told& told : facts.findings) {
    const std::string text = output::diagnostic_json(told.diagnostic, sources);
    std::fwrite(text.data(), 1, text.size(), stderr);
  }
}

}  // namespace

ExitStatus stock(const StockOptions& options) {
  auto program = kept_program(options.run.program);
  if (!program) return fail(program.error());
  auto source = program->open();
  if (!source) return fail(source.error());
  auto ordered = job_of(options.run, **source);
  if (!ordered) return fail(ordered.error());
  ReadyRun ready{nullptr, ordered->choice, ordered->hint};
  auto job = stock_job(options.run, std::move(*ordered), std::move(*program), **source);
  if (!job) return fail(job.error());
  auto cut = job::cut_stock(*job);
  if (!cut) return fail(cut.error());
  output::StockFacts facts = job::facts_of(*cut);
  facts.shape = shape_word(options.run.table);
  facts.run.chosen = ready.choice.chosen;
  leave_out(options.run.table, facts);
  ready.run = std::move(cut->run);
  const base::SourceSet& sources = ready.machine().sources();
  if (!options.report.empty()) {
    auto file = base::OutputFile::create(options.report);
    if (!file) return fail(file.error());
    (*file)->write(output::stock_report_json(facts, sources));
    if (auto committed = (*file)->commit(); !committed) return fail(committed.error());
  }
  report_diagnostics(ready, options.run.diagnostics);
  tell_findings(options, facts, sources);
  const ExitStatus ended = exit_status_of(cut->status);
  return ended == ExitStatus::well && fails(options.run.table, facts) ? ExitStatus::findings
                                                                      : ended;
}

}  // namespace kerf::cli
