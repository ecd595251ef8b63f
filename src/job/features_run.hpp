#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "features/recognition.hpp"
#include "job/run.hpp"
#include "job/stock_job.hpp"

namespace kerf::job {

/// What a run has machined, recognised.
struct FeaturesResult {
  std::unique_ptr<Run> run;  ///< over: its sources, what it came to
  machine::RunStatus status{};
  machine::StockZero zero;  ///< of the stock; never automatic
  stock::Vec3 origin;       ///< of that, machine coordinates
  /// What lies on the table; none: nothing was cut, and nobody has said.
  std::optional<stock::Workpiece> shape;
  bool knows_stock = true;
  features::Recording recording;
  features::Bounds bounds;  ///< of recognition
  features::Tree tree;
  std::vector<control::Assumption> assumed;
  /// Recognition ended beyond its bounds: why, a warning without a place. The status is `budget`
  /// then, after an alarm `alarm`.
  std::optional<base::Diagnostic> notice;
};

/// Gives the machine of a run sinks of its own.
using LookOn = std::function<void(machine::BatchRun& machine)>;
/// Runs the job once: all but the tree. Failures as recognise_features() has them.
[[nodiscard]] base::Outcome<FeaturesResult> record_features(const StockJob& job,
                                                            const LookOn& look_on = {});
/// What such a run has machined.
[[nodiscard]] features::Tree recognised(const FeaturesResult& result, features::Method method);
/// Likewise as the tree of the result, with a notice where bounds ended it.
void recognise(FeaturesResult& result, features::Method method);

/// Runs the job once, and recognises what it machines; of the stock job what it cuts is not asked.
/// Recognition has as much time as the run, ends with it when the job is no longer wanted, and
/// keeps no more than the memory of the job. Failures as Run::of() has them, and (usage) for
/// machines that neither mill nor turn.
[[nodiscard]] base::Outcome<FeaturesResult> recognise_features(const StockJob& job,
                                                               features::Method method);

}  // namespace kerf::job
