#pragma once

#include <functional>
#include <vector>

#include "job/internal/stock_pass.hpp"
#include "job/pass_watch.hpp"
#include "stock/cutting/finding.hpp"

namespace kerf::job {

/// So many sweeps are cut before those who look on see them.
inline constexpr std::size_t kWatchedBatch = 1024;

/// A pass with this plan, for those who look on. All must be there until it is over.
[[nodiscard]] ModelBegin begin_of(const StockJob& job, const StockPlan& plan, const Run& run,
                                  stock::Model& model,
                                  std::function<std::vector<stock::Finding>()> findings);

}  // namespace kerf::job
