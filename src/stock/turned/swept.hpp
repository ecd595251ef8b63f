#pragma once

#include <cstdint>
#include <vector>

#include "geometry/contour/passage.hpp"

namespace kerf::stock::turned {

/// The way of a tip in the plane (u = Z, v = X), and what edges that it leaves are to remember.
struct Pass {
  std::vector<contour::Edge> path;
  std::uint32_t motion = 0;
};

// What a tool goes over on the way of its tip: contours that wind >= 0 everywhere. What lies at
// v < 0 counts at |ρ|, so that is there above the axis, too (stock.md §4.6).

/// By a region whose origin the tip leads; one that is convex takes less work.
[[nodiscard]] std::vector<contour::Contour> swept(const contour::Region& region, bool is_convex,
                                                  const Pass& pass);
/// By edges alone; a way without length sweeps nothing with them.
[[nodiscard]] std::vector<contour::Contour> swept(const std::vector<contour::Edge>& edges,
                                                  const Pass& pass);
/// About swept() of what is in the box.
[[nodiscard]] contour::Box swept_box(const contour::Box& box, const Pass& pass);

}  // namespace kerf::stock::turned
