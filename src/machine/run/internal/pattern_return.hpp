#pragma once

#include <functional>

#include "base/axes.hpp"
#include "machine/definition/pattern_machine.hpp"
#include "machine/dialect/pattern_queue.hpp"
#include "motion/motion.hpp"

namespace kerf::machine {

/// The way back to where a pattern begins, record by record, from where the joints stand. The
/// motors go one by one, by counting: a straight way of the tip may not be possible, above all
/// where the arm is stretched.
void each_move_of_return(
    const PatternMachine& machine, const base::JointPoint& joints,
    const std::function<void(const QueuedRecord&, const motion::Motion&)>& take);

}  // namespace kerf::machine
