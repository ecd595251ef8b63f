#pragma once

#include "base/result.hpp"
#include "base/source_file.hpp"
#include "job/stock_job.hpp"
#include "job/stock_run.hpp"
#include "machine/definition/set_up.hpp"

namespace kerf::job {

/// Lays on the table of a job what a set-up names: files are read, shapes put where they are
/// clamped, checks chosen. Where it has no stock, a WORKPIECE comment of the program says what it
/// is. Precondition: the machine of the job and its memory are known. Failure (usage): the machine
/// cannot have such a thing; (input): a file cannot be read, or does not fit into the memory.
[[nodiscard]] base::Outcome<void> lay(const machine::SetUp& set_up, const base::SourceFile& program,
                                      StockJob& job);

/// Adds what was taken otherwise than it was said to what the run has assumed.
void tell_notes(const StockJob& job, StockResult& result);

}  // namespace kerf::job
