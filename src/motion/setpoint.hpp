#pragma once

#include "base/point.hpp"
#include "motion/mark.hpp"

namespace kerf::motion {

/// Where the tool is at one moment: tool tip, machine coordinates, tool length left out, in the
/// order of the program's axes.
struct Setpoint {
  double time_s = 0;  ///< from the start of the run; a multiple of the period, if there is one
  base::TipPoint tip;
  Mark mark;  ///< the motion that is under way, or that ends here
};

}  // namespace kerf::motion
