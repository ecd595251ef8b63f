#pragma once

#include <cstdint>

#include "geometry/contour/region.hpp"

namespace kerf::stock::compare::test {

/// Counterclockwise; each edge is this owner's.
inline contour::Region rectangle(contour::Vec2 low, contour::Vec2 high, std::uint32_t owner = 0) {
  return contour::region_of(contour::Contour{{{low, 0, owner},
                                              {{high.u, low.v}, 0, owner},
                                              {high, 0, owner},
                                              {{low.u, high.v}, 0, owner}}});
}

}  // namespace kerf::stock::compare::test
