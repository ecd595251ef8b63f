#pragma once

#include <vector>

#include "geometry/vec2.hpp"

namespace kerf::process {

using geometry::Vec2;

/// A stretch of a scan line with the beam on.
struct Run {
  double from = 0;   ///< mm from the line's origin
  double to = 0;     ///< > from
  double power = 1;  ///< share of the operation's power
};

/// A straight way of the tool, at feed, with runs of beam in ascending order.
struct ScanLine {
  Vec2 origin;
  Vec2 along;  ///< of length 1
  std::vector<Run> runs;
};

}  // namespace kerf::process
