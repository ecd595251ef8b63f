#pragma once

#include <cstdint>

#include "control/gcode/cycles/turning_shape.hpp"
#include "geometry/vec2.hpp"

namespace kerf::control {

/// Which way the passes of a roughing cycle cut: along Z at levels of X (G71), or along X at levels
/// of Z (G72).
enum class Travel : std::uint8_t { along_z, along_x };

/// The frame in which every roughing cycle is one of an outer diameter toward the chuck: u along
/// the travel of the passes, growing as they cut; v the height above the work, growing toward the
/// start point. Made of the plane's coordinates by exchange and change of sign alone, so that
/// mirrored shapes have the same numbers in it, to the last bit.
///
///      v ^   C ____________________ levels
///        |   |      ______________/
///        |   |  ___/   the shape
///        |   P0/
///        +-----------------------------> u
class TurningFrame {
 public:
  /// The directions are those of the points, whatever the signs of allowances: the work lies where
  /// P0 is, seen from the start point, and the passes cut toward the point of the shape that is
  /// farthest from P0 (its last one, unless the shape comes back). Where P0 is as high as the
  /// start, the work lies toward the point that is farthest from it; where the shape has no length
  /// along the travel, the passes cut from the start toward P0.
  TurningFrame(const TurningShape& shape, Travel travel);

  [[nodiscard]] geometry::Vec2 local(geometry::Vec2 in_plane) const;
  [[nodiscard]] geometry::Vec2 in_plane(geometry::Vec2 local) const;
  /// Whether what is clockwise in one of them is counterclockwise in the other.
  [[nodiscard]] bool turns_over() const { return exchanged_ != (sign_u_ * sign_v_ < 0); }

 private:
  [[nodiscard]] geometry::Vec2 exchanged(geometry::Vec2 point) const;

  bool exchanged_;
  double sign_u_ = 1;
  double sign_v_ = 1;
};

}  // namespace kerf::control
