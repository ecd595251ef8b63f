#pragma once

#include "geometry/contour/region.hpp"

namespace kerf::contour {

/// Booleans of regions. Borders that they share, or that run beside each other no farther than
/// kSame_mm, leave neither slivers nor gaps. n log n in the number of edges, and linear in that of
/// places where borders meet. Edges keep their owners; where both have one, that of the first.
[[nodiscard]] Region unite(const Region& a, const Region& b);
[[nodiscard]] Region intersect(const Region& a, const Region& b);
[[nodiscard]] Region subtract(const Region& a, const Region& b);
[[nodiscard]] Region symmetric_difference(const Region& a, const Region& b);

/// The union of any number.
[[nodiscard]] Region unite(const std::vector<Region>& regions);

/// The region without any of the others, which may overlap. What of them lies beside the region's
/// box costs nothing but a look at its loops.
[[nodiscard]] Region subtract(const Region& region, const std::vector<const Region*>& others);

}  // namespace kerf::contour
