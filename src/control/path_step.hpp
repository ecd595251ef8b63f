#pragma once

#include "base/place.hpp"
#include "control/motion.hpp"
#include "geometry/corner.hpp"

namespace kerf::control {

/// A programmed move within a plane: a line (fast or at feed) or an arc, in machine coordinates.
struct PathStep {
  Motion motion;          ///< as programmed
  base::Place place{};    ///< of its block, for alarms
  geometry::Piece piece;  ///< its projection on the plane
};

}  // namespace kerf::control
