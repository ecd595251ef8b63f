#pragma once

#include <optional>
#include <string>

#include "base/result.hpp"
#include "job/stock_job.hpp"
#include "stock/cutting/cutter.hpp"

namespace kerf::job {

/// Where a job wants to be cut to (StockJob::until), as a place on a motion.
struct FoundEnd {
  std::optional<stock::CutEnd> end{};  ///< none: all is cut
  std::string remark{};  ///< why all is cut though something else was asked for; else empty
};

/// Runs the program without cutting anything. Failure: as Run::of().
///
/// A line: the end of the last motion before the first one that a block on this line of the
/// program's own file makes; where it makes none, before the first one behind its beginning. A
/// time: the motion that is under way then, cut in part, by time along it.
[[nodiscard]] base::Outcome<FoundEnd> find_end(const StockJob& job);

}  // namespace kerf::job
