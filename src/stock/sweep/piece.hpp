#pragma once

#include "stock/sweep/way.hpp"

namespace kerf::stock {

/// Material that hangs together.
struct Piece {
  double volume_mm3 = 0;
  Bounds extents;
  bool held = true;  ///< by what the stock is clamped in
};

}  // namespace kerf::stock
