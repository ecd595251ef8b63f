#pragma once

#include "base/place.hpp"
#include "geometry/corner.hpp"
#include "motion/motion.hpp"

namespace kerf::control {

/// A programmed move within a plane: a line (fast or at feed) or an arc, in machine coordinates.
struct PathStep {
  motion::Motion motion;  ///< as programmed
  base::Place place{};    ///< of its block, for alarms
  geometry::Piece piece;  ///< its projection on the plane
  /// Of a move that corners cut into parts: each of them ends at rest, not only the last one.
  bool every_part_stops = false;
};

/// The step as a part of its move that others follow.
[[nodiscard]] inline PathStep inner_part(PathStep step) {
  step.motion.exact_stop = step.every_part_stops;
  return step;
}

}  // namespace kerf::control
