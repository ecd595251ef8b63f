#pragma once

#include "base/point.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"

namespace kerf::motion {

/// How far a motion reaches along each axis.
struct MotionExtent {
  base::TipPoint low, high;

  void reach(const base::TipPoint& point);
};

/// Of a move that begins at `from`, which itself does not count: its end, and the bulges of arcs.
/// Precondition: the motion has a target, and `from` is where it begins.
[[nodiscard]] MotionExtent extent_of(const AxisSetup& axes, const base::TipPoint& from,
                                     const Motion& motion);

}  // namespace kerf::motion
