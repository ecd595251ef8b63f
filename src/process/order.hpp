#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec2.hpp"

namespace kerf::process {

using geometry::Vec2;

/// Something that is made at once. It may begin at any of its entries, and ends where that one's
/// way ends: an open contour has two entries, a closed one as many as it may be begun at.
struct Entry {
  Vec2 begin;
  Vec2 end;
};

struct Item {
  std::vector<Entry> entries;  ///< at least one
  /// Items that must be made before this one: those inside of it.
  std::vector<std::uint32_t> before;
};

struct Turn {
  std::uint32_t item = 0;
  std::uint32_t entry = 0;
};

struct Order {
  std::vector<Turn> turns;       ///< each item once
  double travel_mm = 0;          ///< from `from` to the first, between them, and to `to`
  double travel_file_mm = 0;     ///< of file_order(), whether or not that keeps `before`
  double travel_nearest_mm = 0;  ///< always to the nearest that may be made
};

/// Where the way begins, and where it leads in the end.
struct Ends {
  Vec2 from;
  bool comes_back = true;
  Vec2 to;  ///< of a way that comes back
};

/// The order of the items with the least way between them that a fixed amount of work finds. Up to
/// 9 items the best one there is, where that amount is enough (it is for 9 contours of 100
/// vertices); else going to the nearest next one, and parts one after the other, each made shorter
/// by 2-opt, Or-opt and other entries among neighbours. `before` is kept; where it goes in circles,
/// as far as it can be. Never longer than going to the nearest, nor than the list with the first
/// entries where that keeps `before`. The same for the same items.
[[nodiscard]] Order find_order(std::span<const Item> items, const Ends& ends);
/// As the list has them, with the first entries, whatever is said of `before`.
[[nodiscard]] Order file_order(std::span<const Item> items, const Ends& ends);

}  // namespace kerf::process
