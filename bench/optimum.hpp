#pragma once

#include <vector>

#include "control/axis_setup.hpp"
#include "control/motion.hpp"
#include "motion/settings.hpp"

namespace kerf::bench {

/// How long the moves take at least on the path that the planner makes of them, without a limit of
/// the jerk: the fastest speeds with which no axis exceeds velocity and acceleration, found by
/// brute force on a grid, independent of cells, bounds and look-ahead. Rests between grid points
/// are only where the path has stops.
///
/// Reachability analysis after H. Pham, Q.-C. Pham, A New Approach to Time-Optimal Path
/// Parameterization Based on Reachability Analysis, IEEE Transactions on Robotics 34 (2018): with z
/// = v² and u = dz/ds / 2 every limit |q' u + q" z| <= A is linear; backwards the largest z of each
/// grid point from which the next can be reached, forwards the largest u that stays below.
[[nodiscard]] double optimal_time_s(const control::AxisSetup& axes,
                                    const motion::AxisLimits& limits,
                                    const motion::Settings& settings,
                                    const std::vector<control::Motion>& motions);

}  // namespace kerf::bench
