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
  std::vector<Turn> turns;  ///< each item once
  double travel_mm = 0;     ///< from `from` to the first, between them, and to `to`
  double travel_file_mm = 0;
  double travel_nearest_mm = 0;
};

/// Where the way begins, and where it leads in the end.
struct Ends {
  Vec2 from;
  bool comes_back = true;
  Vec2 to;  ///< of a way that comes back
};

/// The order of the items with the least way between them that a fixed amount of work finds: the
/// best there is up to 9 items without any `before`; else greedy, then 2-opt and Or-opt over
/// neighbour lists, reversals and other entries. Never longer than the order of the list with the
/// first entries, nor than going to the nearest next one. The same for the same items.
[[nodiscard]] Order find_order(std::span<const Item> items, const Ends& ends);
/// As the list has them, with the first entries, `before` kept where the list does.
[[nodiscard]] Order file_order(std::span<const Item> items, const Ends& ends);

}  // namespace kerf::process
