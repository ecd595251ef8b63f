#pragma once

#include <string>

#include "geometry/contour/region.hpp"

namespace kerf::features {

/// What lies on the table before the first cut. Coordinates of the machine, mm; of a lathe its half
/// section (z, radius) stands in `outline`.
struct Blank {
  bool is_known =
      false;  ///< somebody has said so; else nothing of it is a border that was cut open
  contour::Region outline{};  ///< of a mill in XY
  double top = 0;
  double bottom = 0;
};

}  // namespace kerf::features
