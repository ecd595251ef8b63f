#pragma once

#include "base/result.hpp"
#include "job/internal/stock_pass.hpp"
#include "job/stock_job.hpp"

namespace kerf::job {

// Whether the machine can have what is asked for. Failure (usage).

[[nodiscard]] base::Outcome<void> suits(const StockJob& job);
/// Nothing is asked for that only a beam has.
[[nodiscard]] base::Outcome<void> without_beam(const StockJob& job);
/// Where the model was asked for by its name.
[[nodiscard]] base::Outcome<void> suits(const StockJob& job, const StockPlan& plan);

}  // namespace kerf::job
