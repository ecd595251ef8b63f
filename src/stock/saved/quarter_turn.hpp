#pragma once

#include <array>
#include <optional>

#include "stock/cutting/placement.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock::saved {

/// A placing that lays each axis along one: which, and in which sense. Grids are permuted by it.
struct QuarterTurn {
  std::array<int, 3> to{0, 1, 2};    ///< the axis that X, Y, Z come to lie along
  std::array<int, 3> sign{1, 1, 1};  ///< 1: in its direction, -1: against it

  /// None: it is no such placing.
  [[nodiscard]] static std::optional<QuarterTurn> of(const Placing& placing);

  /// The axis that comes to lie along this one.
  [[nodiscard]] int from(int axis) const;
  /// Z stays along Z, or comes to lie against it.
  [[nodiscard]] bool keeps_z() const { return to[2] == 2; }
  [[nodiscard]] bool is_upright() const { return keeps_z() && sign[2] > 0; }
};

/// The box of what was in a box.
[[nodiscard]] Bounds placed_box(const Bounds& box, const Placing& placing);

}  // namespace kerf::stock::saved
