#pragma once

#include "geometry/contour/contour.hpp"

namespace kerf::process {

/// A loop beside `path` at half the kerf, in which arcs about its corners are lines that go on to
/// where they meet, no farther than twice the kerf from the corner.
[[nodiscard]] contour::Contour with_sharp_corners(const contour::Contour& loop,
                                                  const contour::Contour& path, double kerf);

}  // namespace kerf::process
