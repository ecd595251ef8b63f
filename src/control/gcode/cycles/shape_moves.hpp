#pragma once

#include <cstdint>

#include "control/gcode/cycles/turning_passes.hpp"
#include "control/gcode/cycles/turning_shape.hpp"
#include "geometry/vec2.hpp"

namespace kerf::control {

/// The cut along a piece that is moved by `offset`, as a move of `block`.
[[nodiscard]] inline TurningMove move_along(const ShapePiece& piece, geometry::Vec2 offset,
                                            std::uint32_t block) {
  return {.kind = TurningMove::Kind::feed,
          .is_arc = piece.is_arc,
          .clockwise = piece.clockwise,
          .to = piece.to + offset,
          .centre = piece.is_arc ? piece.centre + offset : geometry::Vec2{},
          .block = block};
}

}  // namespace kerf::control
