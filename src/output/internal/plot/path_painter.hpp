#pragma once

#include "output/internal/plot/label_placer.hpp"
#include "output/internal/plot/subject.hpp"
#include "output/internal/plot/view.hpp"

namespace kerf::output::plot {

/// Draws the path as seen in `view`: travelling first, dashed and clipped to the frame, then the
/// cuts of each tool in its colour. What lies exactly on top of the same tool's line is drawn once.
/// Lines are thinner where a dense path would only give a blot.
void draw_path(DisplayList& sheet, const View& view, const Subject& subject);

/// Marks where the first cut starts and the last one ends; without cuts, the path.
void draw_ends(DisplayList& sheet, const View& view, const Subject& subject, LabelPlacer& labels);

/// The number of each tool beside its first cut, when there is more than one.
void draw_tool_labels(DisplayList& sheet, const View& view, const Subject& subject,
                      LabelPlacer& labels);

/// The marks themselves, for the legend.
void draw_start_mark(DisplayList& sheet, Point at);
void draw_end_mark(DisplayList& sheet, Point at);

}  // namespace kerf::output::plot
