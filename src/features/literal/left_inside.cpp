#include "features/literal/left_inside.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "features/path/tolerance.hpp"
#include "geometry/contour/offset.hpp"

namespace kerf::features {

// What no disc fits into needs no offset: inside a small loop of many chords those all meet.
bool is_left_inside(const contour::Contour& loop, double radius) {
  const contour::Box box = contour::extents(loop);
  const contour::Vec2 size = box.high - box.low;
  if (std::min(size.u, size.v) <= 2 * radius) return false;
  if (std::fabs(contour::area(loop)) <= std::numbers::pi * radius * radius) return false;
  const contour::Region left = contour::offset(contour::region_of(loop), -radius);
  return contour::area(left) > kEmptyArea_mm2;
}

}  // namespace kerf::features
