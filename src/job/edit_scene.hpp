#pragma once

#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "features/edit/edit.hpp"
#include "features/edit/fault.hpp"
#include "features/merge/merge.hpp"
#include "features/plan/edit_plan.hpp"
#include "features/plan/edit_sketch.hpp"
#include "features/rewrite/old_ways.hpp"
#include "job/edit_result.hpp"
#include "job/features_run.hpp"
#include "job/stock_job.hpp"

namespace kerf::job {

class BlockTexts;

/// What edits would make of a program, not run yet.
struct EditDraft {
  features::EditPlan plan{};
  EditResult result{};  ///< its report is not verified
};

/// What edits are made on: a program that has run once, what it machines, its text. All of it stays
/// as it is, however many edits are tried, so that each of them takes but the time of its own. One
/// thread at a time.
class EditScene {
 public:
  /// `before` must be a run of this job, with both methods of recognition asked.
  EditScene(StockJob job, FeaturesResult before);
  ~EditScene();
  EditScene(const EditScene&) = delete;
  EditScene& operator=(const EditScene&) = delete;

  [[nodiscard]] const StockJob& job() const { return job_; }
  [[nodiscard]] FeaturesResult& features() { return before_; }
  [[nodiscard]] const FeaturesResult& features() const { return before_; }

  /// The contours behind the edits. No path is made.
  [[nodiscard]] features::EditSketch sketch(const std::vector<features::Edit>& edits) const;
  /// Plans the edits and merges them into the text.
  [[nodiscard]] features::Editing<EditDraft> draft(const EditWishes& wishes);
  /// Runs a draft and holds it against what was asked; a draft that changes nothing is one that is
  /// verified. Failures as recognise_features() has them. `unwanted` ends the run.
  [[nodiscard]] base::Outcome<features::Editing<EditResult>> verified(
      EditDraft draft, std::stop_token unwanted = {}) const;

 private:
  void read_texts();
  void describe_tools(const std::vector<features::Edit>& edits);

  StockJob job_;
  FeaturesResult before_;
  features::OldWays ways_{before_.recording};
  std::unique_ptr<BlockTexts> blocks_;
  std::map<base::FileId, std::vector<std::uint32_t>> named_;  // N words that jumps and calls name
  std::optional<features::MergeSources> sources_;             // none: it is no G-code
};

}  // namespace kerf::job
