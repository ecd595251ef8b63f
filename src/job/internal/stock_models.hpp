#pragma once

#include <memory>
#include <optional>
#include <string>

#include "job/internal/stock_pass.hpp"
#include "job/internal/stock_shape.hpp"
#include "output/reports/stock_facts.hpp"
#include "stock/dexel/shape.hpp"
#include "stock/dexel/tri_dexel.hpp"

namespace kerf::job {

/// Says which model holds the part and why, by what is known before it is cut.
void choose_model(const StockJob& job, const SurveyedTools& tools, StockPlan& plan);

/// A shape as dexels have it.
[[nodiscard]] stock::dexel::Shape dexels_of(const stock::Workpiece& piece);

struct MadeModel {
  std::unique_ptr<stock::Model> model;
  double turning_tolerance_mm = 0.001;
  double cell_mm = 0;  ///< that it was made by; 0: it has none
  /// The cell does not fit into the memory: what was asked for and what it is now.
  std::optional<std::string> cell_enlarged;
};

/// How large a model may be, and how many threads cut it.
struct ModelSize {
  std::size_t memory_bytes = 0;  ///< of the model
  std::size_t of_bytes = 0;      ///< with what stands beside it, as its user has said it
  unsigned jobs = 0;             ///< StockJob::jobs
  int most_along = 0;            ///< StockJob::most_along
  bool turns = false;            ///< on a lathe
  double least_cell_mm = 0;      ///< StockJob::least_cell_mm

  [[nodiscard]] static ModelSize of(const StockJob& job) {
    return {job.memory_for_model(), job.memory_bytes,           job.jobs,
            job.most_along,         job.job.definition.turns(), job.least_cell_mm};
  }
};
/// The cell that the model will have: that of the plan, or as much more as the memory asks for.
/// Precondition: no profile.
[[nodiscard]] double cell_of(const StockPlan& plan, const ModelSize& size);
[[nodiscard]] MadeModel make_model(const StockPlan& plan, const ModelSize& size);

/// The dexels of a model; null: it has none.
[[nodiscard]] const stock::dexel::TriDexel* dexels_of(const stock::Model& model);

/// What reports say of a model that was made so.
[[nodiscard]] output::StockFacts::Model facts_of(const StockPlan& plan, const stock::Model& model);

}  // namespace kerf::job
