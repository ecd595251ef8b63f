#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/result.hpp"
#include "base/source_file.hpp"
#include "job/stock_run.hpp"
#include "stock/compare/part.hpp"

namespace kerf::job {

/// What `--against` names: what another program has left of the same piece, or a part that was
/// saved. It moves and does not copy.
struct OtherPart {
  std::string name;                       ///< what reports call it
  std::optional<StockResult> cut{};       ///< by another program; none: it was saved
  std::unique_ptr<stock::Model> model{};  ///< that was saved; null: the other one cut, a sheet
  std::optional<stock::Bounds> piece{};   ///< that a saved one was cut from, where it says so
  stock::Bounds box{};                    ///< that holds it
  std::unique_ptr<stock::compare::Part> solid{};  ///< of the ones above
};

/// Leaves room for another part in the memory of a job that will be compared with one.
void share_memory(StockJob& job);

/// Cuts the stock of `other` as that of `job` was cut, which left `cut`: the same piece in the same
/// cells. Where the other one needs dexels or larger cells, the first is cut again with them.
/// Failure: as cut_stock() has them.
[[nodiscard]] base::Outcome<OtherPart> cut_other(StockJob& job, StockResult& cut, StockJob other,
                                                 const std::string& name);

/// Reads a part that was saved, and counts its memory. Failure (input): as read_part() has them, or
/// the machine of the job makes no such part.
[[nodiscard]] base::Outcome<OtherPart> read_other(const base::SourceFile& file, StockJob& job);

/// Compares what is left with the other part: fills in StockResult::against, and warns where they
/// differ by more than the job's tolerance. Failure (input): it was cut from another piece, or has
/// no place in common with this one.
[[nodiscard]] base::Outcome<void> compare_with_other(const StockJob& job, const OtherPart& other,
                                                     StockResult& result);

}  // namespace kerf::job
