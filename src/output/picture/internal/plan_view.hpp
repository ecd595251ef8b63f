#pragma once

#include "output/picture/drawing/view.hpp"
#include "output/picture/internal/path_painter.hpp"
#include "output/picture/internal/subject.hpp"

namespace kerf::output::plot {

/// Draws the flat view of a path with rulers at its frame, which has room for their labels to the
/// left (kRulerLeft) and below (kRulerBelow): from above with the holes marked, or, of a machine
/// without Y, as a lathe is drawn.
Look draw_plan(DisplayList& sheet, const View& view, const Subject& subject);

inline constexpr double kRulerLeft = 84, kRulerBelow = 44;

}  // namespace kerf::output::plot
