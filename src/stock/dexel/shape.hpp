#pragma once

#include <functional>
#include <vector>

#include "stock/sweep/way.hpp"

namespace kerf::stock::dexel {

/// Material along a dexel: from low to high, with the directions that its faces look to, unit.
struct Interval {
  double low = 0;
  double high = 0;
  Vec3 low_normal;
  Vec3 high_normal;
};

/// Appends the intervals of a shape, in order and apart from each other, along the line through
/// (b, c): `axis` 0, 1, 2 is X, Y, Z, b the coordinate on the next axis, c on the one after that
/// (X: Y and Z, Y: Z and X, Z: X and Y). Called from several threads at once.
using Inside = std::function<void(int axis, double b, double c, std::vector<Interval>& out)>;

/// What a stock is before the first cut, in its own frame, mm.
struct Shape {
  Bounds box;  ///< holds all of it; low < high
  Inside inside;
  double volume_mm3 = 0;  ///< exact; 0: as the dexels have it
};

[[nodiscard]] Shape box_shape(const Bounds& box);
/// A cylinder along `axis`, or a tube where inner_mm > 0: centre (b, c) as Inside has them, radii.
struct Round {
  int axis = 2;
  double b = 0;
  double c = 0;
  double low = 0;
  double high = 0;
  double radius_mm = 0;
  double inner_mm = 0;
};
[[nodiscard]] Shape round_shape(const Round& round);

}  // namespace kerf::stock::dexel
