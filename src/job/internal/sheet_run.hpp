#pragma once

#include "job/stock_run.hpp"

namespace kerf::job {

/// Whether the stock of this job is a sheet under a beam: the machine has a laser.
[[nodiscard]] bool has_beam(const StockJob& job);

/// cut_stock() of a job with a beam. Failure (usage): the stock is no sheet.
[[nodiscard]] base::Outcome<StockResult> cut_sheet(const StockJob& job);

}  // namespace kerf::job
