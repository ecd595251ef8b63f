#pragma once

#include <cstdint>
#include <optional>

#include "control/gcode/cycles/turning_frame.hpp"
#include "control/gcode/cycles/turning_shape.hpp"
#include "geometry/vec2.hpp"

namespace kerf::control {

/// Why a roughing cycle cannot turn a shape, and where that begins.
struct ShapeFault {
  enum class Reason : std::uint8_t {
    not_monotone_first_axis,   ///< PS0064: back against the travel, Z of G71, X of G72
    not_monotone_second_axis,  ///< PS0329: type I, back down into the work: a pocket
    outside_start              ///< PS0322: beyond the start point in one of the axes
  };
  Reason reason;
  std::uint32_t block;  ///< ShapePiece::block, or TurningShape::first_block
};

/// Whether shapes with pockets (type II) can be turned along `travel`, and this is one.
[[nodiscard]] inline bool may_have_pockets(const TurningShape& shape, Travel travel) {
  return shape.both_axes && travel == Travel::along_z;
}

/// On which side of the shape, as it is followed, its start and so what is to be cut lie: above 0
/// left of it, below 0 right, 0 where nothing lies between. Arcs count as their chords.
[[nodiscard]] double side_of_start(const TurningShape& shape);

/// The first fault along the shape, none where it can be turned. `tolerance`: by how much it may go
/// back, u along Z, v along X as a radius, mm >= 0; it counts from the farthest point so far.
[[nodiscard]] std::optional<ShapeFault> check_shape(const TurningShape& shape, Travel travel,
                                                    geometry::Vec2 tolerance);

}  // namespace kerf::control
