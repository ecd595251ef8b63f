#pragma once

#include <span>
#include <vector>

#include "stock/dexel/shape.hpp"
#include "stock/dexel/tile.hpp"

namespace kerf::stock::dexel {

/// The ends of what a shape has along a dexel; `middle` is that of the stock's box. What is shorter
/// than Tile::kLeast_mm is none.
[[nodiscard]] inline std::vector<DexelEnd> ends_of(const std::vector<Interval>& intervals,
                                                   double middle) {
  const auto end = [&](double at, Vec3 normal, std::uint32_t motion) {
    return DexelEnd{static_cast<float>(at - middle), octahedral(normal), 0, motion};
  };
  std::vector<DexelEnd> ends;
  for (const Interval& each : intervals) {
    if (each.high - each.low < Tile::kLeast_mm) continue;
    ends.push_back(end(each.low, each.low_normal, each.low_motion));
    ends.push_back(end(each.high, each.high_normal, each.high_motion));
  }
  return ends;
}

/// mm of material.
[[nodiscard]] inline double length_of(std::span<const DexelEnd> ends) {
  double length = 0;
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    length += double{ends[i + 1].at} - double{ends[i].at};
  }
  return length;
}

/// In order, and within the box.
[[nodiscard]] inline bool is_sound(std::span<const DexelEnd> ends, double half) {
  double last = -half * (1 + 1e-6);
  for (const DexelEnd& end : ends) {
    if (!(double{end.at} >= last)) return false;
    last = double{end.at};
  }
  return last <= half * (1 + 1e-6);
}

}  // namespace kerf::stock::dexel
