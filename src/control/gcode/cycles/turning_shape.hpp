#pragma once

#include <cstdint>
#include <vector>

#include "geometry/vec2.hpp"

namespace kerf::control {

/// A piece of a shape to be turned, in the plane of the spindle's axis: u along Z, v along X as a
/// radius, mm.
struct ShapePiece {
  geometry::Vec2 from{};
  geometry::Vec2 to{};
  bool is_arc = false;      ///< one whose ends are the same point is a full circle
  bool clockwise = false;   ///< in (Z, X), as G02
  geometry::Vec2 centre{};  ///< its distances from the ends may differ a little
  std::uint32_t block = 0;  ///< whose piece it is: the caller's index
};

/// What the blocks ns to nf of a multiple repetitive cycle describe.
struct TurningShape {
  geometry::Vec2 start;           ///< A: where the tool stood before the cycle
  bool approach_is_rapid = true;  ///< ns is G00
  bool both_axes = false;         ///< ns has X and Z: a shape of type II, which may have pockets
  std::vector<ShapePiece>
      pieces;                     ///< from the end of ns on, each beginning where the last one ends
  std::uint32_t first_block = 0;  ///< ns
};

/// Where ns ends and the shape begins: P0. A without pieces.
[[nodiscard]] inline geometry::Vec2 first_point(const TurningShape& shape) {
  return shape.pieces.empty() ? shape.start : shape.pieces.front().from;
}

}  // namespace kerf::control
