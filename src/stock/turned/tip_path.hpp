#pragma once

#include <vector>

#include "geometry/contour/edge.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock::turned {

/// A spiral of a program's rounded arc is divided so that no arc leaves it by more than this.
inline constexpr double kPathError_mm = 1e-6;

/// Whether the tip stays in the plane of Z and X, on lines and circles.
[[nodiscard]] bool is_in_plane(const Way& way);

/// The way as lines and arcs of at most half a circle in (u = Z, v = X), at least one; of a way
/// that leads nowhere a line without length. Precondition: is_in_plane().
[[nodiscard]] std::vector<contour::Edge> tip_path(const Way& way);

}  // namespace kerf::stock::turned
