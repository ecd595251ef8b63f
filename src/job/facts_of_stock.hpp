#pragma once

#include <string>

#include "job/stock_run.hpp"
#include "output/reports/stock_facts.hpp"

namespace kerf::job {

/// What the cut stock came to, for reports; `shape` is the caller's words. Precondition: the
/// result still has its run.
[[nodiscard]] output::StockFacts facts_of(StockResult& result);

/// Of pictures and files of the part: the program and the machine that cut it. Precondition: the
/// result still has its run.
[[nodiscard]] std::string title_of(const StockResult& result);

/// A finding with the place of its block, as diagnostics have it.
[[nodiscard]] output::StockFacts::Told told(const stock::Finding& finding,
                                            const machine::BatchRun& run);

}  // namespace kerf::job
