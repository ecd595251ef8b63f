#pragma once

#include <string>
#include <vector>

#include "control/axis_setup.hpp"
#include "control/motion.hpp"
#include "kinematics/settings.hpp"
#include "motion/settings.hpp"
#include "random_machine.hpp"
#include "seeded_random.hpp"

namespace kerf::test {

/// A machine with random limits and a random program for it, all from one seed.
struct RandomPath {
  control::AxisSetup axes;
  std::optional<RandomMachine> machine;  ///< none: the driven axes are the program's
  motion::AxisLimits limits;             ///< of the driven axes
  motion::Settings settings;
  std::vector<control::Motion> motions;
};

/// Lines, arcs, helices, arcs in space, chains of 0.1 mm arcs, curves written as points, 5-axis
/// moves, stops, dwells and rapids. Number of axes, limits, period and tolerance are random as
/// well, and the sizes of a linkage.
[[nodiscard]] RandomPath random_path(unsigned seed,
                                     kinematics::Kind kind = kinematics::Kind::cartesian);

}  // namespace kerf::test
