#pragma once

#include "geometry/contour/region.hpp"
#include "stock/surface/surface.hpp"

namespace kerf::stock::surface {

/// A region of the plane as a plate between two heights, low < high; chords lie no farther from its
/// arcs than `tolerance_mm` > 0. Walls have the owners of their edges, top and bottom 0.
[[nodiscard]] Surface plate(const contour::Region& region, double low, double high,
                            double tolerance_mm);

}  // namespace kerf::stock::surface
