#pragma once

#include <cstdint>
#include <vector>

#include "stock/sheet/grid.hpp"

namespace kerf::stock::sheet {

/// Which items come to which tiles of a grid. An item has a box and a distance from places; it
/// comes to a tile where that may be less than its reach.
class TileList {
 public:
  explicit TileList(const Grid& grid) : grid_(grid) {}

  /// Item `number` with its box, reach included; `distance(place)` is that from its way.
  template <typename Distance>
  void add(std::uint32_t number, const Box& box, double reach, const Distance& distance) {
    const Range range{tile_x(box.low.u), tile_x(box.high.u), tile_y(box.low.v), tile_y(box.high.v)};
    if (!(box.high.u > grid_.box.low.u && box.low.u < grid_.box.high.u)) return;
    if (!(box.high.v > grid_.box.low.v && box.low.v < grid_.box.high.v)) return;
    number_ = number;
    descend(range, reach, distance);
  }

  struct Run {
    std::size_t tile;
    std::size_t first;  ///< its items are number(first) to number(end - 1), in their order
    std::size_t end;
  };
  /// By tiles. Behind the last add().
  [[nodiscard]] std::vector<Run> runs();
  [[nodiscard]] std::uint32_t number(std::size_t place) const {
    return static_cast<std::uint32_t>(keys_[place]);
  }
  [[nodiscard]] std::size_t size() const { return keys_.size(); }

 private:
  /// Tiles, both ends included.
  struct Range {
    int i0, i1, j0, j1;
  };

  template <typename Distance>
  void descend(const Range& range, double reach, const Distance& distance) {
    const int wide = range.i1 - range.i0;
    const int high = range.j1 - range.j0;
    if (wide == 0 && high == 0) return put(range);
    Range first = range;
    Range second = range;
    if (wide >= high) {
      first.i1 = range.i0 + wide / 2;
      second.i0 = first.i1 + 1;
    } else {
      first.j1 = range.j0 + high / 2;
      second.j0 = first.j1 + 1;
    }
    near(first, reach, distance);
    near(second, reach, distance);
  }
  template <typename Distance>
  void near(const Range& range, double reach, const Distance& distance) {
    if (distance(middle(range)) <= half_diagonal(range) + reach) descend(range, reach, distance);
  }

  [[nodiscard]] int tile_x(double x) const;
  [[nodiscard]] int tile_y(double y) const;
  [[nodiscard]] Vec2 middle(const Range& range) const;
  [[nodiscard]] double half_diagonal(const Range& range) const;
  void put(const Range& tile);

  const Grid& grid_;
  std::uint32_t number_ = 0;
  std::vector<std::uint64_t> keys_;  // tile, number
};

}  // namespace kerf::stock::sheet
