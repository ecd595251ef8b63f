#pragma once

#include <memory>

#include "job/stock_run.hpp"
#include "stock/compare/part.hpp"

namespace kerf::job {

/// What a run has left, to be compared. The result outlives it.
[[nodiscard]] std::unique_ptr<stock::compare::Part> solid_of(const StockResult& result);
/// The same where it shall be a design: of a sheet the pieces that lie in that, most of each; the
/// others are scrap.
[[nodiscard]] std::unique_ptr<stock::compare::Part> solid_of(const StockResult& result,
                                                             const stock::compare::Solid& design);

/// How they lie to each other, places of a turned part in its half plane: X is ρ, Y is 0.
[[nodiscard]] stock::compare::Comparison compared(const StockJob& job, const StockResult& result,
                                                  const stock::compare::Part& part,
                                                  const stock::compare::Solid& wanted);

/// Threads that compare for a job.
[[nodiscard]] unsigned threads_for(const StockJob& job);

}  // namespace kerf::job
