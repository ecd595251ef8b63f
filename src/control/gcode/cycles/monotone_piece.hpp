#pragma once

#include <cstdint>
#include <vector>

#include "control/gcode/cycles/turning_frame.hpp"
#include "control/gcode/cycles/turning_shape.hpp"
#include "geometry/vec2.hpp"

namespace kerf::control {

/// Heights that differ by no more than this are one level: more than rounding, less than anything
/// programmed, mm.
inline constexpr double kSameLevel_mm = 1e-10;

/// A piece of a shape in the turning frame, which neither turns back along u nor along v: a line or
/// at most a quarter of a circle.
struct MonotonePiece {
  geometry::Vec2 from{};
  geometry::Vec2 to{};
  bool is_arc = false;
  bool clockwise = false;  ///< in (u, v)
  geometry::Vec2 centre{};
  std::uint32_t block = 0;

  [[nodiscard]] bool rises() const { return to.v > from.v + kSameLevel_mm; }
  [[nodiscard]] bool falls() const { return to.v < from.v - kSameLevel_mm; }
  /// The point at `height`: on the line, or where the circle crosses the level; an end where the
  /// piece does not reach it. Of an arc whose ends have different radii, on the radius between.
  [[nodiscard]] geometry::Vec2 at_height(double height) const;
};

/// The shape, moved by `offset` (in the plane) into the frame, with its arcs cut where they turn
/// back. Pieces without length are left out; each begins exactly where the last one ends.
[[nodiscard]] std::vector<MonotonePiece> monotone_pieces(const TurningShape& shape,
                                                         const TurningFrame& frame,
                                                         geometry::Vec2 offset);

/// Drops the pieces at the end that lead back against the travel: shapes that are not checked may
/// return to the face with their last block, which is no wall to any level.
void drop_way_back(std::vector<MonotonePiece>& pieces);

}  // namespace kerf::control
