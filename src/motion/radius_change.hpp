#pragma once

#include <cmath>

#include "motion/plane_axes.hpp"

namespace kerf::motion {

/// An arc whose radius changes by more is a spiral.
inline constexpr double kSameRadius_mm = 0.001;

/// By how much the radii at begin and end of an arc differ, which begins at `from`.
[[nodiscard]] inline double radius_change(const PlaneAxes& plane, const base::TipPoint& from,
                                          const Arc& arc) {
  const geometry::Vec2 centre{arc.center[0], arc.center[1]};
  return std::fabs(length(plane.project(arc.to) - centre) - length(plane.project(from) - centre));
}

}  // namespace kerf::motion
