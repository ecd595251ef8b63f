#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "geometry/vec2.hpp"

namespace kerf::drawing {

using geometry::Vec2;

/// A Bezier curve of degree N - 1, or a part of one.
template <std::size_t N>
struct Bezier {
  std::array<Vec2, N> points;

  [[nodiscard]] Vec2 begin() const { return points.front(); }
  [[nodiscard]] Vec2 end() const { return points.back(); }
  /// Also where the curve stands for a moment: towards the first other point of its polygon.
  [[nodiscard]] Vec2 begins() const {
    for (std::size_t i = 1; i < N; ++i)
      if (is_far(points[i], points.front())) return points[i] - points.front();
    return points.back() - points.front();
  }
  [[nodiscard]] Vec2 ends() const {
    for (std::size_t i = N - 1; i-- > 0;)
      if (is_far(points[i], points.back())) return points.back() - points[i];
    return points.back() - points.front();
  }
  [[nodiscard]] bool is_point() const {
    for (const Vec2 point : points)
      if (is_far(point, points.front())) return false;
    return true;
  }
  [[nodiscard]] std::pair<Bezier, Bezier> parted(double t) const {
    Bezier low;
    Bezier high = *this;
    for (std::size_t i = 0; i < N; ++i) {
      low.points[i] = high.points[0];
      for (std::size_t k = 0; k + 1 < N - i; ++k)
        high.points[k] = (1 - t) * high.points[k] + t * high.points[k + 1];
    }
    return {low, high};
  }
  [[nodiscard]] std::pair<Bezier, Bezier> halves() const { return parted(0.5); }

 private:
  /// Nearer points give no direction: it would be one of rounding.
  static bool is_far(Vec2 a, Vec2 b) {
    constexpr double kNear_mm = 1e-9;
    return std::abs(a.u - b.u) > kNear_mm || std::abs(a.v - b.v) > kNear_mm;
  }
};

}  // namespace kerf::drawing
