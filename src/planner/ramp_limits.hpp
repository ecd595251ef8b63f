#pragma once

#include <cstddef>

#include "motion/curve.hpp"
#include "planner/settings.hpp"

namespace kerf::planner {

/// What a ramp with limited jerk may use along the path, both > 0.
struct RampLimits {
  double acceleration = 0;
  double jerk = 0;
};

/// How hard a part of the path may be sped up and slowed down on when `speed` > 0 is never
/// exceeded.
///
/// A ramp that has the acceleration a is slower than where it ends: taking a to 0 with the jerk j
/// adds a²/2j to the speed. So what the shape of the path leaves is asked at v = speed - a²/2j, for
/// every a up to the result, and not at `speed` with all of it:
///
///   q' a + q'' v² <= A,   q' j + 3 q'' v a + q''' v³ <= J   for every axis.
///
/// A ramp within a part of these limits, lower speed included, is within them. Of the pairs that
/// hold, the one with which a ramp from rest to `speed` is fastest.
///
/// Precondition: at `speed` the shape leaves something of A and J of each axis.
[[nodiscard]] RampLimits ramp_limits(const motion::CurveBounds& bounds, const AxisLimits& limits,
                                     std::size_t axes, double speed);

}  // namespace kerf::planner
