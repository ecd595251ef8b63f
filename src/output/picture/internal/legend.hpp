#pragma once

#include "output/picture/internal/subject.hpp"

namespace kerf::output::plot {

/// What the colours, lines and marks mean, and the extents of the path, in a strip of the given
/// place and width, kLegendHeight high.
void draw_legend(DisplayList& sheet, Point corner, double width, const Subject& subject);

inline constexpr double kLegendHeight = 136;

}  // namespace kerf::output::plot
