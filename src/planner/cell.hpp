#pragma once

#include <cstdint>

#include "planner/cell_limits.hpp"
#include "planner/overrides.hpp"
#include "planner/profile.hpp"

namespace kerf::planner {

/// A part of the path that is driven within one set of limits, or a dwell. At any speed up to the
/// limit of velocity, with any acceleration and jerk along the path up to theirs, no axis exceeds a
/// limit of its own, and the tip stays within the chord tolerance between two set-points.
struct Cell {
  std::uint64_t piece = 0;  ///< number of the piece of the path
  double begin = 0;         ///< the part of its curve, by its parameter
  double end = 0;
  PathLimits limits;
  double dwell_s = 0;  ///< > 0: a dwell
  bool stop = false;   ///< the axes come to rest at its end
  // What the plan does not read comes last: there are many cells, and a cache is small.
  Overrides overrides;         ///< that the limits are for
  Overrides former_overrides;  ///< and those before, while others are tried
  CellBounds bounds;

  [[nodiscard]] double length() const { return end - begin; }
};

}  // namespace kerf::planner
