#pragma once

#include <vector>

#include "features/milling/shaped_level.hpp"

namespace kerf::features {

/// What a level has of parallel lines.
struct LinePasses {
  bool clears = false;          ///< they are the longest part of it, and go on to one side
  bool goes_both_ways = false;  ///< there and back
  bool is_one_way = false;      ///< the whole level is one pass from an end to an end
  std::vector<double> steps;    ///< from pass to pass
};
[[nodiscard]] LinePasses line_passes_of(const Recording& recording, const ShapedLevel& shaped);

}  // namespace kerf::features
