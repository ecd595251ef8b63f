#include "face/cli/table_run.hpp"

#include <cstdio>
#include <utility>

#include "face/cli/operator_input.hpp"
#include "face/cli/stock_order.hpp"
#include "job/facts_of_stock.hpp"
#include "output/reports/stock_report.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::cli {

base::Outcome<TableRun> run_on_table(const RunOptions& options) {
  auto program = kept_program(options.program);
  if (!program) return tl::unexpected(program.error());
  auto source = program->open();
  if (!source) return tl::unexpected(source.error());
  auto ordered = job_of(options, **source);
  if (!ordered) return tl::unexpected(ordered.error());
  TableRun made{.cut = {}, .facts = {}, .ready = {nullptr, ordered->choice, ordered->hint}};
  auto job = stock_job(options, std::move(*ordered), std::move(*program), **source);
  if (!job) return tl::unexpected(job.error());
  job->job.input = kept_operator_input();
  auto cut = job::cut_stock(*job);
  if (!cut) return tl::unexpected(cut.error());
  made.cut = std::move(*cut);
  made.facts = job::facts_of(made.cut);
  made.facts.shape = shape_word(options.table);
  made.facts.run.chosen = made.ready.choice.chosen;
  job->job.skips = made.cut.skips;
  auto again = job::Run::of(job->job);
  if (!again) return tl::unexpected(again.error());
  made.ready.run = std::move(*again);
  return made;
}

void report_stock(const RunOptions& options, const output::StockFacts& facts,
                  const base::SourceSet& sources) {
  if (options.diagnostics != DiagnosticFormat::json) {
    const std::string text = output::stock_report_text(facts, sources);
    std::fwrite(text.data(), 1, text.size(), stderr);
    return;
  }
  for (const output::StockFacts::Told& told : facts.findings) {
    const std::string text = output::diagnostic_json(told.diagnostic, sources);
    std::fwrite(text.data(), 1, text.size(), stderr);
  }
}

}  // namespace kerf::cli
