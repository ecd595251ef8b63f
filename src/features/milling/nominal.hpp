#pragma once

#include <functional>

#include "geometry/contour/contour.hpp"

namespace kerf::features {

/// Whether an arc of a wall is only what a round tool leaves in a corner.
using IsToolCorner = std::function<bool(const contour::Edge& arc)>;

/// The contour with sharp corners where the tool has rounded them: where such an arc goes over
/// smoothly into lines on both sides, and these meet. Closed, in normal form; `is_island`: what
/// stands is inside of it.
[[nodiscard]] contour::Contour sharpened(const contour::Contour& contour, bool is_island,
                                         const IsToolCorner& is_tool_corner);

}  // namespace kerf::features
