#pragma once

#include <cstdint>
#include <vector>

#include "drawing/drawing.hpp"
#include "geometry/vec2.hpp"

namespace kerf::drawing {

/// An end of an open path. Ends are numbered: 2 i is the beginning of path i, 2 i + 1 its end.
struct PathEnd {
  geometry::Vec2 at;
  geometry::Vec2 outwards;  ///< direction in which the path would go on, not 0
  Group group{};            ///< only ends of one group are joined
};

/// Another end's number, or kAlone.
using Partner = std::uint32_t;
inline constexpr Partner kAlone = 0xffffffffU;

/// For each end the one that it is joined with: ends of one group at most `join_mm` apart, the
/// nearest ones first, then in the order of their numbers; where more than two are at one place,
/// those that turn least.
[[nodiscard]] std::vector<Partner> partners_of(const std::vector<PathEnd>& ends, double join_mm);

struct EndPair {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  double distance_mm = 0;
};

/// Pairs of ends that have no partner, of one group and at most `most_mm` apart, each end in one
/// pair at most, nearest first.
[[nodiscard]] std::vector<EndPair> near_pairs(const std::vector<PathEnd>& ends,
                                              const std::vector<Partner>& partners, double most_mm);

}  // namespace kerf::drawing
