#pragma once

#include <functional>

#include "geometry/contour/region.hpp"
#include "output/picture/drawing/display_list.hpp"

namespace kerf::output::plot {

/// Where a point of the plane is on the sheet; must keep circles round.
using ToSheet = std::function<Point(geometry::Vec2)>;

/// The loops of a region, arcs as curves: within a thousandth of their radius.
[[nodiscard]] Outline path_of(const contour::Region& region, const ToSheet& to_sheet);
/// Goes on along an edge from where the outline is.
void follow(Outline& outline, const contour::Edge& edge, const ToSheet& to_sheet);
/// Lines at 45 degrees over what lies inside of a region, `apart` from each other on the sheet.
[[nodiscard]] Outline hatch(const contour::Region& region, const ToSheet& to_sheet, double apart);

}  // namespace kerf::output::plot
