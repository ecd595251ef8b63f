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
  features::Tree tree;
  std::vector<control::Assumption> assumed;
};

/// Gives the machine of a run sinks of its own.
using LookOn = std::function<void(machine::BatchRun& machine)>;
/// Runs the job once: all but the tree. Failures as recognise_features() has them.
[[nodiscard]] base::Outcome<FeaturesResult> record_features(const StockJob& job,
                                                            const LookOn& look_on = {});
/// What such a run has machined.
[[nodiscard]] features::Tree recognised(const FeaturesResult& result, features::Method method);

/// Runs the job once, and recognises what it machines; of the stock job what it cuts is not asked.
/// Failures as Run::of() has them, and (usage) for machines that neither mill nor turn.
[[nodiscard]] base::Outcome<FeaturesResult> recognise_features(const StockJob& job,
                                                               features::Method method);

}  // namespace kerf::job
