#pragma once

#include "output/picture/drawing/label_placer.hpp"
#include "output/picture/drawing/view.hpp"
#include "output/picture/internal/subject.hpp"

namespace kerf::output::plot {

/// Marks where the first cut starts and the last one ends; without cuts, the path.
void draw_ends(DisplayList& sheet, const View& view, const Subject& subject, LabelPlacer& labels);

/// Marks the holes in their last tool's colour: circle and cross, smaller where holes lie close, or
/// dots where they lie very close. Marks that would lie on one another are drawn once.
void draw_holes(DisplayList& sheet, const View& view, const Subject& subject);

/// The number of each tool beside its first cut, when there is more than one.
void draw_tool_labels(DisplayList& sheet, const View& view, const Subject& subject,
                      LabelPlacer& labels);

/// Single marks, for the legend.
void draw_start_mark(DisplayList& sheet, Point at);
void draw_end_mark(DisplayList& sheet, Point at);
void draw_hole_mark(DisplayList& sheet, Point at);

}  // namespace kerf::output::plot
