#pragma once

#include <vector>

#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "planner/settings.hpp"

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
[[nodiscard]] double optimal_time_s(const motion::AxisSetup& axes,
                                    const planner::AxisLimits& limits,
                                    const planner::Settings& settings,
                                    const std::vector<motion::Motion>& motions);

}  // namespace kerf::bench
