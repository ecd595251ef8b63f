#pragma once

#include <string>

#include "base/program_text.hpp"
#include "base/result.hpp"
#include "base/source_file.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/ready_run.hpp"
#include "job/stock_job.hpp"
#include "output/reports/stock_facts.hpp"

namespace kerf::cli {

/// The program at a path, which may be run several times: standard input is read once and kept.
/// Failure (input).
[[nodiscard]] base::Outcome<base::ProgramText> kept_program(const std::string& path);

/// What the words of a command line put on the table, around a job that job_of() has made of the
/// same options. `source` is the program, opened. Failure (usage): a word is wrong; (input): the
/// file of tools cannot be read.
[[nodiscard]] base::Outcome<job::StockJob> stock_job(const RunOptions& run, OrderedJob ordered,
                                                     base::ProgramText program,
                                                     const base::SourceFile& source);

/// The shape on the table as reports call it.
[[nodiscard]] std::string shape_word(const TableOptions& options);
/// Whether a finding makes the command fail.
[[nodiscard]] bool fails(const TableOptions& options, const output::StockFacts& facts);

}  // namespace kerf::cli
