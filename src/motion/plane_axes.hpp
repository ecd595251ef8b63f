#pragma once

#include <optional>

#include "geometry/vec2.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"

namespace kerf::motion {

/// The axes of a plane: first, second and the normal to both (docs/dialect.md §8.2), and the
/// letters of the centre offsets along the first two.
struct PlaneAxes {
  base::Axis first{};
  base::Axis second{};
  std::optional<base::Axis> normal;
  char first_offset = 'I';
  char second_offset = 'J';

  [[nodiscard]] geometry::Vec2 project(const base::AxisVector& point) const {
    return {point[first], point[second]};
  }
  void place(base::AxisVector& point, geometry::Vec2 at) const {
    point[first] = at.u;
    point[second] = at.v;
  }
  [[nodiscard]] bool contains(base::Axis axis) const { return axis == first || axis == second; }
};

/// The axes of `plane`, or nothing when the machine lacks one of its two.
[[nodiscard]] inline std::optional<PlaneAxes> plane_axes(Plane plane, const AxisSetup& axes) {
  const auto x = axes.find('X');
  const auto y = axes.find('Y');
  const auto z = axes.find('Z');
  if (plane == Plane::xy && x && y) return PlaneAxes{*x, *y, z, 'I', 'J'};
  if (plane == Plane::zx && x && z) return PlaneAxes{*z, *x, y, 'K', 'I'};
  if (plane == Plane::yz && y && z) return PlaneAxes{*y, *z, x, 'J', 'K'};
  return std::nullopt;
}

}  // namespace kerf::motion
