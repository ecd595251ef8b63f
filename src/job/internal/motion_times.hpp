#pragma once

#include <vector>

#include "job/job.hpp"
#include "stock/cutting/finding.hpp"

namespace kerf::job {

/// When the motion of each finding ends, seconds of the run; 0 of those without one. Runs the
/// program again, as far as the last of them, to see its set-points.
[[nodiscard]] std::vector<double> times_of(const Job& job,
                                           const std::vector<stock::Finding>& findings);

}  // namespace kerf::job
