#pragma once

#include "geometry/contour/region.hpp"

namespace kerf::contour {

/// What is no farther than `distance` >= 0 from the region; for `distance` < 0 what is no nearer
/// than that to anything outside. All loops together: islands merge, walls vanish. Lines and arcs
/// stay what they are, outer corners become arcs about them. An edge has the owner of the edge that
/// it is parallel to, an arc about a corner that of the edge before. As n log n, and linear in the
/// number of places where the raw offset crosses itself.
[[nodiscard]] Region offset(const Region& region, double distance);

/// The parallel at `distance` to the right of an open contour (< 0: to its left), in its direction:
/// of all points at this distance those that nothing of the contour is nearer to. It may be in
/// several parts, in the order of the contour.
[[nodiscard]] std::vector<Contour> parallel(const Contour& open, double distance);

}  // namespace kerf::contour
