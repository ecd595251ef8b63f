#include "face/server/hub/internal/scene_making.hpp"

#include "base/refusal.hpp"
#include "face/server/hub/internal/part_job.hpp"

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

Outcome<std::shared_ptr<job::EditScene>> SceneMaking::make() {
  auto job = stock_job();
  if (!job) return tl::unexpected(job.error());
  auto result = job::record_features(*job);
  if (!result) return tl::unexpected(result.error());
  if (!order_.unwanted.stop_requested())
    result->tree = job::recognised(*result, features::Method::both);
  return std::make_shared<job::EditScene>(std::move(*job), std::move(*result));
}

}  // namespace kerf::server
