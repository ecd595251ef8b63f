#pragma once

#include <array>
#include <cstddef>

#include "geometry/vec2.hpp"

namespace kerf::geometry {

/// A line without ends (direction of any length but 0) or a circle.
struct Curve {
  bool is_circle = false;
  Vec2 point;         ///< of the line, or the circle's centre
  Vec2 direction;     ///< of the line
  double radius = 0;  ///< of the circle, >= 0
};

/// Up to two common points.
struct Intersections {
  std::array<Vec2, 2> points{};
  std::size_t count = 0;
};

/// Common points of two curves. Curves that miss each other by no more than `tolerance` touch;
/// equal and parallel curves have none.
[[nodiscard]] Intersections intersect(const Curve& a, const Curve& b, double tolerance);

}  // namespace kerf::geometry
