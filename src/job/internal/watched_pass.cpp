#include "job/internal/watched_pass.hpp"

#include "job/facts_of_stock.hpp"
#include "job/internal/stock_models.hpp"

namespace kerf::job {
namespace {

using Told = output::StockFacts::Told;

/// Only what a model is made by.
std::function<std::unique_ptr<stock::Model>(double)> maker_of(const StockJob& job,
                                                              const StockPlan& plan) {
  StockJob like;
  like.job.definition = job.job.definition;
  like.memory_bytes = job.memory_bytes;
  like.jobs = job.jobs;
  return [plan, like, most_along = job.most_along](double cell_mm) {
    StockPlan with_cell = plan;
    StockJob for_cell = like;
    if (cell_mm > 0) with_cell.cell_mm = cell_mm;
    if (cell_mm == 0) for_cell.most_along = most_along;
    return make_model(with_cell, for_cell).model;
  };
}

}  // namespace

PassBegin begin_of(const StockJob& job, const StockPlan& plan, const Run& run, stock::Model& model,
                   std::function<std::vector<stock::Finding>()> findings) {
  return {.run = run,
          .origin = plan.origin,
          .shape = plan.shape,
          .facts = facts_of(plan, model),
          .model = model,
          .like = maker_of(job, plan),
          .usual_cell_mm = plan.cell_mm,
          .is_like_before = !plan.looks.empty(),
          .findings = [findings = std::move(findings), &run] {
            std::vector<Told> all;
            for (const stock::Finding& each : findings()) all.push_back(told(each, run.machine()));
            return all;
          }};
}

}  // namespace kerf::job
