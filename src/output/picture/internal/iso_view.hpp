#pragma once

#include "output/picture/drawing/view.hpp"
#include "output/picture/internal/path_painter.hpp"
#include "output/picture/internal/subject.hpp"

namespace kerf::output::plot {

/// Draws the isometric view of a path: the box around it with rulers at three of its edges and a
/// grid on its floor, the path, and arrows that show where X, Y and Z go.
Look draw_iso(DisplayList& sheet, const View& view, const Subject& subject);

}  // namespace kerf::output::plot
