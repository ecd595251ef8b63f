#pragma once

#include <optional>

#include "geometry/vec2.hpp"

namespace kerf::drawing {

using geometry::Vec2;

/// A map of the plane that keeps lines straight and parallels parallel.
struct Affine {
  Vec2 x{1, 0};  ///< where (1, 0) goes, without the shift
  Vec2 y{0, 1};
  Vec2 shift{};

  [[nodiscard]] constexpr Vec2 direction(Vec2 v) const { return v.u * x + v.v * y; }
  [[nodiscard]] constexpr Vec2 operator()(Vec2 point) const { return direction(point) + shift; }
  /// Negative: it mirrors.
  [[nodiscard]] constexpr double determinant() const { return geometry::cross(x, y); }

  /// `first` and then `second`.
  [[nodiscard]] friend constexpr Affine then(const Affine& first, const Affine& second) {
    return {second.direction(first.x), second.direction(first.y), second(first.shift)};
  }
  [[nodiscard]] static constexpr Affine moved(Vec2 by) { return {{1, 0}, {0, 1}, by}; }
  [[nodiscard]] static constexpr Affine scaled(double along_x, double along_y) {
    return {{along_x, 0}, {0, along_y}, {}};
  }
  /// Counterclockwise about zero.
  [[nodiscard]] static Affine turned(double angle_rad);

  /// How many times longer everything gets, where that is the same in all directions to within one
  /// part in 10^9: circles stay circles.
  [[nodiscard]] std::optional<double> scale() const;
};

}  // namespace kerf::drawing
