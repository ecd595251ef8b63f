#pragma once

#include <vector>

#include "output/reports/stock_facts.hpp"
#include "stock/cutting/cutter.hpp"

namespace kerf::job {

/// The threads that a run has cut, by the blocks that began them.
[[nodiscard]] std::vector<output::StockFacts::Thread> threads_of(const stock::Model& model,
                                                                 const stock::Cutter& cutter);

}  // namespace kerf::job
