#pragma once

#include "geometry/contour/region.hpp"

namespace kerf::contour {

enum class Relation : std::uint8_t {
  equal,
  contains,  ///< the first the second
  inside,    ///< the first in the second
  disjoint,  ///< no area in common
  overlaps,
};

struct Related {
  Relation relation = Relation::disjoint;
  bool touches = false;  ///< borders have a point in common

  friend bool operator==(const Related&, const Related&) = default;
};

/// How two regions lie to each other, by their areas: what is less than kNoArea_mm2 is none.
/// Nothing is equal to nothing and disjoint from everything else.
[[nodiscard]] Related relation(const Region& first, const Region& second);

}  // namespace kerf::contour
