#pragma once

#include <string>
#include <vector>

#include "geometry/contour/contour.hpp"

namespace kerf::output {

/// Contours as the data of one SVG path, lines as L, arcs as A; coordinates as they are, moved by
/// `by`, with four digits behind the point.
[[nodiscard]] std::string svg_path(const std::vector<contour::Contour>& contours, contour::Vec2 by);

/// Text between tags or in an attribute.
[[nodiscard]] std::string xml_text(const std::string& text);

}  // namespace kerf::output
