#pragma once

#include "base/result.hpp"
#include "job/stock_run.hpp"

namespace kerf::job {

/// Leaves room for another part in the memory of a job that will be compared with one.
void share_memory(StockJob& job);

/// Cuts the stock of `other` as that of `job` was cut, which left `cut`: the same piece in the same
/// cells. Where the other one needs dexels, the first is cut again with them. Failure: as
/// cut_stock() has them.
[[nodiscard]] base::Outcome<StockResult> cut_other(StockJob& job, StockResult& cut, StockJob other);

/// What `--against` names is a saved part, not a program: its first bytes say so.
[[nodiscard]] bool is_saved_part(const std::string& path);

/// Compares what is left with what the other one has left: fills in StockResult::against, and warns
/// where they differ by more than the job's tolerance. `name` is what reports call the other one.
void compare_with_other(const StockJob& job, const std::string& name, const StockResult& other,
                        StockResult& result);

}  // namespace kerf::job
