#pragma once

#include <memory>

#include "geometry/contour/region.hpp"
#include "job/stock_run.hpp"
#include "stock/compare/part.hpp"

namespace kerf::job {

/// What a model holds of this piece, to be compared. The model outlives it.
[[nodiscard]] std::unique_ptr<stock::compare::Part> solid_of(const stock::Model& model,
                                                             const stock::Bounds& piece);
/// Pieces of a sheet, as thick as that.
[[nodiscard]] std::unique_ptr<stock::compare::Part> plate_of(const contour::Region& pieces,
                                                             const stock::Bounds& sheet);
/// What a run has left. The result outlives it; of a sheet the job has kept the ways.
[[nodiscard]] std::unique_ptr<stock::compare::Part> solid_of(const StockResult& result);
/// The same where it shall be a design: of a sheet the pieces that lie in that, most of each; the
/// others are scrap.
[[nodiscard]] std::unique_ptr<stock::compare::Part> solid_of(const StockResult& result,
                                                             const stock::compare::Solid& design);

/// How they lie to each other, places of a turned part in its half plane: X is ρ, Y is 0.
[[nodiscard]] stock::compare::Comparison compared(const StockJob& job, const StockResult& result,
                                                  const stock::compare::Part& part,
                                                  const stock::compare::Solid& wanted);

/// Threads that compare for a job.
[[nodiscard]] unsigned threads_for(const StockJob& job);

}  // namespace kerf::job
