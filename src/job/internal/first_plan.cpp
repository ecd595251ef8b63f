#include "job/internal/first_plan.hpp"

#include "job/internal/run_rack.hpp"
#include "job/internal/stock_models.hpp"
#include "job/internal/stock_shape.hpp"
#include "job/internal/survey_pass.hpp"
#include "job/stock_run.hpp"
#include "stock/cutting/saved_part.hpp"

namespace kerf::job {
namespace {

using base::Outcome;

/// A part that was cut before, with cells of its own; null: something else lies there.
const stock::SavedPart* saved_part(const StockJob& job) {
  const auto* const piece = std::get_if<stock::Workpiece>(&job.shape);
  const auto* const saved = piece != nullptr ? std::get_if<stock::SavedShape>(piece) : nullptr;
  return saved != nullptr ? saved->part.get() : nullptr;
}

/// The cells of a plan: of what was cut before its own.
double cell_for(const StockJob& job, const SurveyedTools& tools) {
  const stock::SavedPart* const saved = saved_part(job);
  if (saved != nullptr && saved->cell_mm() > 0) return saved->cell_mm();
  return job.cell_mm.value_or(tools.usual_cell());
}

bool needs_survey(const StockJob& job) {
  const bool needs_cell = !job.cell_mm && !job.job.definition.turns() && saved_part(job) == nullptr;
  return std::holds_alternative<machine::StockAround>(job.shape) || needs_cell;
}

/// What probes meet, found with cells of a usual size.
Outcome<machine::Skips> skips_of(const StockJob& job) {
  StockJob rough = job;
  rough.cell_mm = SurveyedTools{}.usual_cell();
  auto cut = cut_stock(rough);
  if (!cut) return tl::unexpected(cut.error());
  return std::move(cut->skips);
}

/// Nothing was cut before the alarm, which is what there is to tell.
stock::Workpiece shape_before_alarm(bool turns, std::vector<control::Assumption>& assumed) {
  assumed.push_back({0, "the alarm comes before the first cut: the stock is 1 mm of material"});
  if (turns) return stock::CylinderShape{.from = -1, .to = 0, .diameter = 1};
  return stock::BoxShape{{0, 0, -1}, {1, 1, 0}};
}

// A program that measures the part goes on by what it has found.
Outcome<StockPlan> plan_by_survey(const StockJob& job, std::vector<control::Assumption>& assumed) {
  auto run = Run::of(job.job);
  if (!run) return tl::unexpected(run.error());
  SurveyPass pass(job, **run);
  const machine::RunStatus status = (*run)->go();
  const bool is_said = job.knows_stock && !std::holds_alternative<machine::StockAround>(job.shape);
  if (pass.has_probed() && is_said) {
    auto skips = skips_of(job);
    if (!skips) return tl::unexpected(skips.error());
    StockJob probed = job;
    probed.job.skips = std::move(*skips);
    if (!probed.job.skips.empty()) return plan_by_survey(probed, assumed);
  }
  StockPlan plan;
  plan.is_surveyed = true;
  for (const auto& [number, cut] : pass.survey().tools()) plan.axial[number] = cut.axial;
  RunRack rack(job, (*run)->machine(), plan.axial);
  plan.origin = pass.origin();
  plan.without_changes = !pass.survey().changes_tool();
  const SurveyedTools tools(pass.survey(), rack, plan.origin);
  auto shape = shape_of(job.shape, job.job.definition.turns(), tools, assumed);
  if (!shape && status == machine::RunStatus::alarm && !pass.survey().has_begun())
    shape = shape_before_alarm(job.job.definition.turns(), assumed);
  if (!shape) return tl::unexpected(shape.error());
  plan.shape = *shape;
  plan.cell_mm = cell_for(job, tools);
  choose_model(job, tools, plan);
  return plan;
}

Outcome<StockPlan> plan_by_guess(const StockJob& job) {
  auto run = Run::of(job.job);
  if (!run) return tl::unexpected(run.error());
  StockPlan plan;
  plan.origin = ZeroWatch((*run)->machine(), job.zero).at_start();
  std::vector<control::Assumption> none;
  auto shape = shape_of(job.shape, job.job.definition.turns(), SurveyedTools{}, none);
  if (!shape) return tl::unexpected(shape.error());
  plan.shape = *shape;
  plan.cell_mm = cell_for(job, SurveyedTools{});
  choose_model(job, SurveyedTools{}, plan);
  return plan;
}

}  // namespace

Outcome<StockPlan> first_plan(const StockJob& job, std::vector<control::Assumption>& assumed) {
  return needs_survey(job) ? plan_by_survey(job, assumed) : plan_by_guess(job);
}

}  // namespace kerf::job
