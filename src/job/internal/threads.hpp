#pragma once

#include <vector>

#include "output/reports/stock_facts.hpp"
#include "stock/cutting/cutter.hpp"

namespace kerf::job {

/// The threads of a turned part, each with the line that cut it; of other models none.
[[nodiscard]] std::vector<output::StockFacts::Thread> threads_of(const stock::Model& model,
                                                                 const stock::Cutter& cutter);

}  // namespace kerf::job
