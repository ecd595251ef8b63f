#pragma once

#include <optional>

#include "drawing/pen.hpp"

namespace kerf::drawing::svg {

/// An arc as path data has it. Which of the four between two points it is, flags say.
struct EndpointArc {
  Vec2 radii;
  double turn_deg = 0;  ///< of the ellipse's first axis
  bool is_large = false;
  bool is_sweep = false;  ///< angles rise
};

struct CentreArc {
  Ellipse ellipse;
  double from_rad = 0;
  double sweep_rad = 0;
};

/// By the formulas of SVG 1.1, F.6.5 and F.6.6: radii that are too small are enlarged. None: a
/// radius is 0, and it is a line. The points differ.
[[nodiscard]] std::optional<CentreArc> by_centre(Vec2 from, Vec2 to, const EndpointArc& arc);

}  // namespace kerf::drawing::svg
