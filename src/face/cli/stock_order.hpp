#pragma once

#include <string>

#include "base/program_text.hpp"
#include "base/result.hpp"
#include "base/source_file.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/ready_run.hpp"
#include "job/stock_job.hpp"
#include "job/stock_run.hpp"
#include "machine/definition/set_up.hpp"
#include "output/reports/stock_facts.hpp"

namespace kerf::cli {

/// The program at a path, which may be run several times: standard input is read once and kept.
/// Failure (input).
[[nodiscard]] base::Outcome<base::ProgramText> kept_program(const std::string& path);

/// What a set-up and the words of a command line put on the table, around a job that job_of() has
/// made of the same options. `source` is the program, opened. Failure (usage): a word is wrong;
/// (input): the file of tools, or one that the set-up names, cannot be read.
[[nodiscard]] base::Outcome<job::StockJob> stock_job(const RunOptions& run,
                                                     const machine::SetUp& set_up,
                                                     OrderedJob ordered, base::ProgramText program,
                                                     const base::SourceFile& source);

/// A command line that puts something on a table, as a job and what belongs to it.
struct TableOrder {
  machine::SetUp set_up;
  ReadyRun ready;  ///< without its run
  job::StockJob job;
};

/// Reads the program and the tools that the options name. Failure (usage), (input): as job_of() and
/// stock_job() have them.
[[nodiscard]] base::Outcome<TableOrder> order_on_table(const RunOptions& options,
                                                       machine::SetUp set_up);

/// Whether a finding is one of those that make the command fail.
[[nodiscard]] bool counts(const machine::SetUp& set_up, const output::StockFacts::Told& told);
/// Whether a finding makes the command fail.
[[nodiscard]] bool fails(const machine::SetUp& set_up, const output::StockFacts& facts);

/// A run whose stock has been cut, what was found, and the same run once more, which nobody has
/// made yet: probes meet there what they met.
struct TableRun {
  machine::SetUp set_up;
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
