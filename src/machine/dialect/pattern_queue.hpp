#pragma once

#include <deque>

#include "drive/arm_axis.hpp"
#include "drive/pattern/record.hpp"

namespace kerf::machine {

/// A record on its way from the control of patterns to the motors.
struct QueuedRecord {
  drive::PatternRecord record;
  drive::ArmCounts from;    ///< the counters where it begins
  bool ends_block = false;  ///< it is the last one of its line
};

/// Of each motion that such a control hands out, the record behind it, in the same order: a motion
/// says where the tip goes, and the motors have to know their pulses.
using PatternQueue = std::deque<QueuedRecord>;

}  // namespace kerf::machine
