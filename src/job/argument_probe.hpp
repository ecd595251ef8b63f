#pragma once

#include "job/features_run.hpp"
#include "job/stock_job.hpp"

namespace kerf::job {

/// Says of every argument of a call of the main file what it reaches: runs the job again with a
/// value that is a hundredth more, at least 0.1, of whole numbers 1, and compares what is
/// recognised. What is no number, what stands in another file, and what makes the program end
/// otherwise is left unsaid. `result`: of the same job.
void probe_arguments(const StockJob& job, features::Method method, FeaturesResult& result);

}  // namespace kerf::job
