#pragma once

#include <string>

#include "output/picture/drawing/view.hpp"
#include "output/picture/internal/path_painter.hpp"
#include "output/picture/internal/subject.hpp"

namespace kerf::output::plot {

/// Draws the flat view of a path with rulers at its frame, which has room for their labels to the
/// left (kRulerLeft) and below (kRulerBelow): from above with the holes marked, or, of a machine
/// without Y, as a lathe is drawn.
Look draw_plan(DisplayList& sheet, const View& view, const Subject& subject);

/// What the rulers of a flat view say.
struct Rulers {
  std::string horizontal, vertical;  ///< their names
  double horizontal_factor = 1;      ///< numbers are coordinates times this
  double vertical_factor = 1;
  bool vertical_from_axis = false;  ///< numbers count from 0 both ways, without a sign
};

/// Rulers with their grid lines, and the border of the frame.
void draw_rulers(DisplayList& sheet, const View& view, const Rulers& rulers);

inline constexpr double kRulerLeft = 84, kRulerBelow = 44;

}  // namespace kerf::output::plot
