#pragma once

#include <string>
#include <vector>

#include "kinematics/settings.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "planner/settings.hpp"
#include "random_machine.hpp"
#include "seeded_random.hpp"

namespace kerf::test {

/// A machine with random limits and a random program for it, all from one seed.
struct RandomPath {
  motion::AxisSetup axes;
  std::optional<RandomMachine> machine;  ///< none: the driven axes are the program's
  planner::AxisLimits limits;            ///< of the driven axes
  planner::Settings settings;
  std::vector<motion::Motion> motions;
};

/// Lines, arcs, helices, arcs in space, chains of 0.1 mm arcs, curves written as points, 5-axis
/// moves, stops, dwells and rapids. Number of axes, limits, period and tolerance are random as
/// well, and the sizes of a linkage.
[[nodiscard]] RandomPath random_path(unsigned seed,
                                     kinematics::Kind kind = kinematics::Kind::cartesian);

}  // namespace kerf::test
