#pragma once

#include <vector>

#include "control/core/assumptions.hpp"
#include "job/internal/stock_pass.hpp"
#include "job/run.hpp"
#include "job/stock_job.hpp"

namespace kerf::job {

/// What the first pass over a program is begun with. Where it must be known what the program cuts,
/// that is looked over before. Failure (usage): the machine cannot have such a stock.
[[nodiscard]] base::Outcome<StockPlan> first_plan(const StockJob& job,
                                                  std::vector<control::Assumption>& assumed);

}  // namespace kerf::job
