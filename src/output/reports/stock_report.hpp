#pragma once

#include <string>

#include "base/source_file.hpp"
#include "output/reports/stock_facts.hpp"
#include "output/reports/summary.hpp"

namespace kerf::output {

/// The report of `kerf stock`, one JSON object and a line end (docs/stock.md).
[[nodiscard]] std::string stock_report_json(const StockFacts& facts,
                                            const base::SourceSet& sources);

/// What its checks have found and could not look at, for the summary of a run.
[[nodiscard]] CheckedStock checked_stock(const StockFacts& facts, const base::SourceSet& sources);

/// The same for people; the summary of the run stands above it.
[[nodiscard]] std::string stock_report_text(const StockFacts& facts,
                                            const base::SourceSet& sources);

}  // namespace kerf::output
