#pragma once

#include "geometry/contour/region.hpp"

namespace kerf::contour {

/// What a disc sweeps whose centre goes along the contour, open or closed: all points no farther
/// than `radius` > 0 from it. Of a line it is a capsule, of an arc an annular sector with round
/// ends. A path of one point is a disc. Owners as offset() has them; the round ends have that of
/// the last edge, and of the first.
[[nodiscard]] Region sweep_of_disc(const Contour& path, double radius);

/// What the region sweeps when it moves straight by `way`, without turning.
[[nodiscard]] Region sweep_along(const Region& region, Vec2 way);

}  // namespace kerf::contour
