#pragma once

#include <optional>
#include <vector>

#include "base/work_limit.hpp"
#include "machine/panel/internal/live_run.hpp"

namespace kerf::machine {

/// Start at a line: the control runs up to it while nothing moves, then the axes are brought to
/// where it has them. What it needs before its first move: the functions that were switched up to
/// there, and where the program has the tool.
class Approach : private motion::MotionSink {
 public:
  /// Runs the control of a program that has not begun up to the line; nothing moves. Failure
  /// (usage): why it does not come there; the run is used up then.
  [[nodiscard]] base::Outcome<void> search(LiveRun& run, Stepper& stepper, std::uint32_t line,
                                           const base::WorkLimit& limit);
  /// What switches the functions and brings the axes there. The tool's axis goes last, or first
  /// where it goes away from the work.
  [[nodiscard]] std::vector<motion::Motion> motions(LiveRun& run,
                                                    const motion::AxisSetup& axes) const;

 private:
  void take(const motion::Motion& motion) override;

  std::optional<motion::Motion> tool_;
  std::optional<motion::Motion> spindle_;
  std::optional<motion::Motion> coolant_;
  base::TipPoint to_;
};

}  // namespace kerf::machine
