#pragma once

#include <string>

#include "geometry/contour/region.hpp"

namespace kerf::output {

/// What the coordinates of an outline are: (Z, ρ) of a lathe, of which X is the diameter, or (X,
/// Y).
enum class ProfileOf : bool { lathe, sheet };

/// Lines and arcs, loop by loop, outer ones counterclockwise. Rows `z,x,bulge`, of a sheet
/// `x,y,bulge`: where an edge begins, and the tangent of a quarter of its angle, 0: a line; an
/// empty line between loops. X of a lathe is a diameter, arcs are those of the radius.
[[nodiscard]] std::string profile_csv(const contour::Region& region, ProfileOf of);
/// One path with the arcs of SVG, true to scale, mm; of a lathe Z to the right and the radius up.
[[nodiscard]] std::string profile_svg(const contour::Region& region, ProfileOf of);
/// Closed polylines with bulges on the layer PROFILE, DXF R12, mm; of a lathe as profile_svg().
[[nodiscard]] std::string profile_dxf(const contour::Region& region);

}  // namespace kerf::output
