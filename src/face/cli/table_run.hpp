#pragma once

#include "face/cli/ready_run.hpp"
#include "job/stock_run.hpp"
#include "output/reports/stock_facts.hpp"

namespace kerf::cli {

/// A run whose stock has been cut, what was found, and the same run once more, which nobody has
/// made yet: probes meet there what they met.
struct TableRun {
  job::StockResult cut;
  output::StockFacts facts;
  ReadyRun ready;
};

/// Cuts the stock of a run. Failure (usage), (input): as make_ready() and stock_job() have them.
[[nodiscard]] base::Outcome<TableRun> run_on_table(const RunOptions& options);

/// Tells of findings and parts on standard error.
void report_stock(const RunOptions& options, const output::StockFacts& facts,
                  const base::SourceSet& sources);

}  // namespace kerf::cli
