#include "stock/dexel/frame.hpp"

#include <cmath>

namespace kerf::stock::dexel {

using geometry::Vec3;

Frame Frame::of(Vec3 axis) {
  if (axis.x == 0 && axis.y == 0) return {{1, 0, 0}, {0, 1, 0}, axis};
  if (axis.y == 0 && axis.z == 0) return {{0, 1, 0}, {0, 0, 1}, axis};
  if (axis.z == 0 && axis.x == 0) return {{0, 0, 1}, {1, 0, 0}, axis};
  const bool is_steep = std::fabs(axis.z) > 0.5;
  const Vec3 across = unit(cross(axis, is_steep ? Vec3{1, 0, 0} : Vec3{0, 0, 1}));
  return {across, cross(axis, across), axis};
}

}  // namespace kerf::stock::dexel
