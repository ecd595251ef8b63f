#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "base/result.hpp"
#include "machine/run/paced_run.hpp"

namespace kerf::machine {

/// When the signal of a macro interrupt comes in a batch run, whose control is ahead of its axes:
/// before which blocks it is answered.
struct InterruptPlan {
  std::vector<std::uint64_t> blocks;  ///< ascending, as Stepper counts them
  std::size_t late = 0;               ///< signals that came when the program was over
};

/// Makes the machine of the run anew: loaded, and nothing has run.
using MakeMachine = std::function<base::Outcome<std::unique_ptr<PacedRun>>()>;

/// Signals at these times of the run, s >= 0, ascending. Each is answered behind the block that the
/// axes are in then, or behind the first one that they can still come to rest at or turn off from.
/// Runs the program some times up to each of them, and has as long as the budget for each of these.
/// Failure (usage): the budget is spent.
[[nodiscard]] base::Outcome<InterruptPlan> plan_interrupts(const MakeMachine& make,
                                                           const std::vector<double>& times_s,
                                                           double budget_s);

}  // namespace kerf::machine
