#include "face/server/hub/internal/scene_making.hpp"

#include <algorithm>

#include "base/refusal.hpp"
#include "face/server/hub/internal/part_job.hpp"
#include "job/facts_of_features.hpp"
#include "output/features/insight.hpp"
#include "output/reports/time_report.hpp"

namespace kerf::server {

using base::Outcome;

namespace {

/// The program under its name, and as it is now: edits are made on its text, and where the library
/// lies is nobody's business.
Outcome<base::ProgramText> whole_text(const PartSource& source) {
  auto text = source.text();
  if (!text || text->text) return text;
  const auto file = text->open();
  if (!file) return tl::unexpected(file.error());
  if ((*file)->size() > SceneMaking::kMostText) {
    return tl::unexpected(
        base::refuse(base::Refusal::features_large,
                     {source.program, std::to_string(SceneMaking::kMostText >> 20U)}));
  }
  std::string bytes((*file)->size(), '\0');
  bytes.resize((*file)->read(0, bytes));
  return base::ProgramText::of(source.program, std::move(bytes));
}

std::string insight_of(const job::StockJob& job, job::FeaturesResult& result,
                       const output::TimeReport& times) {
  const std::string& text = *job.job.program.text;
  output::InsightFacts facts{.features = job::facts_of(result),
                             .bytes = text.size(),
                             .tools = times.tool_times(),
                             .axes = &job.job.definition.axes};
  const auto ends = std::count(text.begin(), text.end(), '\n');
  const bool is_open = !text.empty() && text.back() != '\n';
  facts.lines = static_cast<std::uint64_t>(ends) + (is_open ? 1 : 0);
  return output::run_insight_members(facts);
}

}  // namespace

Outcome<job::StockJob> SceneMaking::stock_job() const {
  PartSource source = order_.source;
  source.text = [&] { return whole_text(order_.source); };
  auto job = part_job(source, order_.set_up, order_.folder, Sight::none);
  if (!job) return job;
  job->job.budget.seconds = kMostSeconds;
  job->job.budget.motions = kMostMotions;
  job->job.budget.input_waits = false;
  job->job.budget.unwanted = order_.unwanted;
  return job;
}

Outcome<std::shared_ptr<job::EditScene>> SceneMaking::make(const Ran& ran) {
  auto job = stock_job();
  if (!job) return tl::unexpected(job.error());
  const machine::MachineDefinition& definition = job->job.definition;
  output::TimeReport times(definition.axes, definition.interpolator.period_s);
  auto result = job::record_features(
      *job, [&](machine::BatchRun& machine) { machine.add_point_sink(times); });
  if (!result) return tl::unexpected(result.error());
  ran(insight_of(*job, *result, times));
  if (!order_.unwanted.stop_requested()) job::recognise(*result, features::Method::both);
  return std::make_shared<job::EditScene>(std::move(*job), std::move(*result));
}

}  // namespace kerf::server
