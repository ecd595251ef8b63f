#pragma once

#include <span>
#include <vector>

#include "geometry/contour/edge.hpp"
#include "process/pass.hpp"

namespace kerf::process {

/// A way from side to side across edges, `width` wide in all, a whole turn each `pitch` mm along
/// them: a zigzag of lines, a sine or circles of short lines.
[[nodiscard]] std::vector<contour::Edge> woven(std::span<const contour::Edge> course,
                                               const Weave& weave);

}  // namespace kerf::process
