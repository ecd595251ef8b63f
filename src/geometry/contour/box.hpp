#pragma once

#include <algorithm>
#include <limits>

#include "geometry/vec2.hpp"

namespace kerf::contour {

using geometry::Vec2;

/// A rectangle along the axes, borders included. As it begins it holds nothing.
struct Box {
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  [[nodiscard]] bool is_empty() const { return low.u > high.u; }
  [[nodiscard]] Vec2 middle() const { return 0.5 * (low + high); }

  void take(Vec2 point) {
    low = {std::min(low.u, point.u), std::min(low.v, point.v)};
    high = {std::max(high.u, point.u), std::max(high.v, point.v)};
  }
  void take(const Box& other) {
    low = {std::min(low.u, other.low.u), std::min(low.v, other.low.v)};
    high = {std::max(high.u, other.high.u), std::max(high.v, other.high.v)};
  }
  [[nodiscard]] Box grown(double by) const { return {low - Vec2{by, by}, high + Vec2{by, by}}; }

  [[nodiscard]] bool meets(const Box& other) const {
    return low.u <= other.high.u && other.low.u <= high.u && low.v <= other.high.v &&
           other.low.v <= high.v;
  }
};

}  // namespace kerf::contour
