#include "job/edit_run.hpp"

#include "job/edit_scene.hpp"

namespace kerf::job {
namespace {

base::Outcome<features::Editing<EditResult>> made(const EditScene& scene,
                                                  const EditWishes& wishes) {
  auto draft = scene.draft(wishes);
  if (!draft) return features::Editing<EditResult>(tl::unexpected(draft.error()));
  return scene.verified(std::move(*draft));
}

}  // namespace

base::Outcome<EditRun> edit_features(const StockJob& job, const EditWishes& wishes) {
  auto before = recognise_features(job, features::Method::both);
  if (!before) return tl::unexpected(before.error());
  EditRun run;
  run.status = before->status;
  EditScene scene(job, std::move(*before));
  if (run.status != machine::RunStatus::alarm && run.status != machine::RunStatus::budget) {
    auto edited = made(scene, wishes);
    if (!edited) return tl::unexpected(edited.error());
    run.edited = std::move(*edited);
  }
  run.run = std::move(scene.features().run);
  return run;
}

}  // namespace kerf::job
