#pragma once

#include <optional>

#include "geometry/contour/region.hpp"
#include "stock/sweep/ball_way.hpp"

namespace kerf::stock::turned {

/// Where the ball of a probe first touches what a region turns to about its axis (stock.md §5,
/// G31): within 1e-9 mm of the gap between them. The nearest place of a body of revolution lies in
/// the half plane through the axis and the middle of the ball, so a disc and the region tell it.
[[nodiscard]] std::optional<double> first_touch(const contour::Region& region, const BallWay& ball);

}  // namespace kerf::stock::turned
