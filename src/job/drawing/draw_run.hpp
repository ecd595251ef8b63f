#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/diagnostic.hpp"
#include "job/drawing/drawn_plan.hpp"
#include "machine/run/batch_run.hpp"
#include "machine/run/budget.hpp"
#include "output/drawings/draw_facts.hpp"

namespace kerf::job {

/// What a machine makes of a plan.
struct DrawResult {
  output::Made made;
  std::vector<output::Made> by_operation;
  machine::RunStatus status = machine::RunStatus::idle;
  std::vector<drawing::Finding> findings;  ///< what the plan meets on the machine
};

/// What looks at the motions while they are made; each outlives the run.
struct DrawWatchers {
  std::vector<motion::MotionSink*> motions;
  std::vector<motion::AxisPointSink*> points;
  /// Before the run and behind it, while its machine is there; may be empty.
  std::function<void(machine::BatchRun&)> prepare;
  std::function<void()> finish;
};

/// Has a machine of the order's definition make it: times and energies, and whether it stays within
/// the travel (DRAW_OUTSIDE) and within reach.
[[nodiscard]] DrawResult make_drawing(const DrawOrder& order,
                                      const std::shared_ptr<const DrawnPlan>& plan,
                                      const machine::Budget& budget, const DrawWatchers& watchers);

}  // namespace kerf::job
