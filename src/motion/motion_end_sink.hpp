#pragma once

#include <cstdint>

#include "base/interface.hpp"

namespace kerf::motion {

/// Is told when the motions of a run end, in the order of the motions: the time at which the axes
/// pass the place that ends it, between two periods of the servo, too. Motions that neither move
/// anything nor last are left out.
///
/// Called on the thread that plans, which may be another one than that of the motions: beside it,
/// and some thousand motions later.
class MotionEndSink : public base::Interface {
 public:
  /// The number of the motion among all that were taken, from 1; seconds from the start of the run,
  /// never less than those of the motion before.
  virtual void motion_ends(std::uint64_t motion, double time_s) = 0;
};

}  // namespace kerf::motion
