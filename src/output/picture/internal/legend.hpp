#pragma once

#include "output/picture/internal/half_section.hpp"
#include "output/picture/internal/subject.hpp"

namespace kerf::output::plot {

/// What the colours, lines and marks mean, and the extents of the path, in a strip of the given
/// place and width, kLegendHeight high. `turning`: of a lathe, else null.
void draw_legend(DisplayList& sheet, Point corner, double width, const Subject& subject,
                 const Turning* turning);

inline constexpr double kLegendHeight = 136;

}  // namespace kerf::output::plot
