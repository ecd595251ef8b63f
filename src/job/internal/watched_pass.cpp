#include "job/internal/watched_pass.hpp"

#include <algorithm>

#include "job/facts_of_stock.hpp"
#include "job/internal/stock_models.hpp"

namespace kerf::job {
namespace {

std::function<std::unique_ptr<stock::Model>(double)> maker_of(const StockJob& job,
                                                              const StockPlan& plan) {
  return [plan, size = ModelSize::of(job)](double cell_mm) {
    StockPlan with_cell = plan;
    ModelSize of = size;
    if (cell_mm > 0) {
      with_cell.cell_mm = cell_mm;
      of.most_along = 0;
    }
    return make_model(with_cell, of).model;
  };
}

}  // namespace

ModelBegin begin_of(const StockJob& job, const StockPlan& plan, const Run& run, stock::Model& model,
                    std::function<std::vector<stock::Finding>()> findings) {
  const auto told_findings = [findings = std::move(findings), &run](std::size_t most) {
    std::vector<stock::Finding> all = findings();
    FoundSoFar found{.first = {}, .count = all.size()};
    all.resize(std::min(most, all.size()));
    for (const stock::Finding& each : all) found.first.push_back(told(each, run.machine()));
    return found;
  };
  return {{run, plan.origin, plan.shape, facts_of(plan, model), told_findings},
          model,
          maker_of(job, plan),
          plan.cell_mm,
          !plan.looks.empty(),
          job.design_in_sight};
}

}  // namespace kerf::job
