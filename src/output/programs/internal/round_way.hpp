#pragma once

#include "base/axes.hpp"
#include "geometry/vec2.hpp"
#include "motion/motion.hpp"
#include "motion/plane_axes.hpp"

namespace kerf::output {

/// The way of a plane arc by the share of it that is done, 0 to 1: the angle, the radius and all
/// other axes change in proportion.
struct RoundWay {
  RoundWay(const motion::PlaneAxes& axes, const base::TipPoint& begin, const motion::Arc& arc);

  [[nodiscard]] base::TipPoint at(double share) const;
  /// Whole number of equal chords that leave the way by at most `tolerance_mm` > 0.
  [[nodiscard]] double chord_count(double tolerance_mm) const;

  motion::PlaneAxes plane;
  base::TipPoint from;
  base::TipPoint to;
  geometry::Vec2 centre;
  double radius;
  double end_radius;
  double start_rad = 0;
  double sweep_rad = 0;  ///< > 0
  double sign = 1;       ///< -1: clockwise
};

}  // namespace kerf::output
