#pragma once

#include <string>
#include <vector>

#include "control/axis_setup.hpp"
#include "control/motion.hpp"
#include "motion/settings.hpp"
#include "seeded_random.hpp"

namespace kerf::test {

/// A machine with random limits and a random program for it, all from one seed.
struct RandomPath {
  control::AxisSetup axes;
  motion::AxisLimits limits;
  motion::Settings settings;
  std::vector<control::Motion> motions;
};

/// Lines, arcs, helices, chains of 0.1 mm arcs, curves written as points, 5-axis moves, stops,
/// dwells and rapids. Number of axes, limits, period and tolerance are random as well.
[[nodiscard]] RandomPath random_path(unsigned seed);

}  // namespace kerf::test
