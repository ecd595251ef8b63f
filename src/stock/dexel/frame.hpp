#pragma once

#include "geometry/vec3.hpp"

namespace kerf::stock::dexel {

/// Directions of a tool in the frame of the stock: `up` its axis, the others across it, unit and
/// perpendicular. Where the axis is one of the stock's so are the others, and nothing is rounded.
struct Frame {
  geometry::Vec3 across;
  geometry::Vec3 aside;
  geometry::Vec3 up;

  /// Precondition: unit.
  [[nodiscard]] static Frame of(geometry::Vec3 axis);

  [[nodiscard]] geometry::Vec3 inside(geometry::Vec3 v) const {
    return {dot(across, v), dot(aside, v), dot(up, v)};
  }
  [[nodiscard]] geometry::Vec3 outside(geometry::Vec3 v) const {
    return v.x * across + v.y * aside + v.z * up;
  }
};

}  // namespace kerf::stock::dexel
