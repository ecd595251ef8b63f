#pragma once

#include <cstdint>
#include <limits>

#include "motion/curve.hpp"

namespace kerf::motion {

/// A part of the path, or a dwell between two of them.
///
/// A part of the path comes with what it allows along it. At any speed up to `velocity`, with any
/// acceleration and jerk along the path up to these, no axis exceeds a limit of its own, and the
/// tip stays within the chord tolerance between two set-points.
struct Cell {
  Curve curve;
  double begin = 0;  ///< the part of the curve, by its parameter
  double end = 0;
  double feed = 0;  ///< what the program asks for, > 0; infinite for rapids
  double velocity = 0;
  double acceleration = 0;
  double jerk = std::numeric_limits<double>::infinity();
  double dwell_s = 0;           ///< > 0: the axes rest this long; there is no curve then
  bool stop = false;            ///< the axes come to rest at its end
  bool fixed_override = false;  ///< the operator cannot change the feed

  [[nodiscard]] double length() const { return end - begin; }
};

}  // namespace kerf::motion
