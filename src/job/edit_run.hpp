#pragma once

#include <memory>

#include "base/result.hpp"
#include "features/edit/fault.hpp"
#include "job/edit_result.hpp"
#include "job/run.hpp"
#include "job/stock_job.hpp"

namespace kerf::job {

/// What came of it: the run of the unedited program, which has its own things to say, and the edit.
struct EditRun {
  std::unique_ptr<Run> run;  ///< over
  machine::RunStatus status{};
  /// Of a program that raised an alarm or used up a budget nothing: `status` says it.
  features::Editing<EditResult> edited{};
};

/// Runs the job, recognises, edits, runs the result and compares. Nothing is written. Failures as
/// recognise_features() has them; an edit that is refused is a fault.
[[nodiscard]] base::Outcome<EditRun> edit_features(const StockJob& job, const EditWishes& wishes);

}  // namespace kerf::job
