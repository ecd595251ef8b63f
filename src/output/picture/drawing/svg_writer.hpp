#pragma once

#include <string>

#include "output/picture/drawing/display_list.hpp"

namespace kerf::output::plot {

/// The drawing as an SVG document that needs nothing else. Coordinates are rounded to a hundredth
/// of a pixel, of a drawing with more than 20 000 points to a tenth; they must stay within 1e6
/// pixels.
[[nodiscard]] std::string write_svg(const DisplayList& drawing);

}  // namespace kerf::output::plot
