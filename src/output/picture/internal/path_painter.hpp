#pragma once

#include "output/picture/drawing/view.hpp"
#include "output/picture/internal/shading.hpp"
#include "output/picture/internal/subject.hpp"

namespace kerf::output::plot {

enum class Look : bool { lines, shaded };

/// Draws the path as seen in `view`: travelling first, dashed and clipped to the frame, then the
/// cuts of each tool in its colour, thinner the closer they lie. A path of few tools with heights
/// that would cover the paper is shaded, in the given order of layers. Returns which of the two it
/// was. Of a subject with a scale the cuts are lines in its colours, what must be seen most
/// on top.
Look draw_path(DisplayList& sheet, const View& view, const Subject& subject, Shading::Order order);

}  // namespace kerf::output::plot
