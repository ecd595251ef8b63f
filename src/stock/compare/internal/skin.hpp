#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "geometry/vec3.hpp"

namespace kerf::stock::compare {

using geometry::Vec3;

/// From where to where a surface goes along Z over a cell; low > high: it has none there.
struct HeightRange {
  float low = 1;
  float high = -1;

  [[nodiscard]] bool is_none() const { return low > high; }
  void take(HeightRange other);
};

/// A surface over cells of a plane, each between two of `x` and two of `y`, found by how near it
/// is: blocks of 4 × 4 cells, of 4 × 4 blocks and so on know their range of heights. 8 bytes for 16
/// cells beside what the caller keeps.
class Skin {
 public:
  struct Cell {
    std::size_t i;
    std::size_t j;
  };
  using RangeOf = std::function<HeightRange(Cell)>;

  Skin() = default;
  /// Cells i lie between x[i] and x[i + 1]; rising, neighbours may be equal. All outlives the skin.
  Skin(const std::vector<double>& x, const std::vector<double>& y, const RangeOf& range_of);

  /// Calls look(cell, square) for cells whose boxes may be as near as `square` mm², which look()
  /// may make smaller, the nearer blocks first.
  template <class Look>
  void search(Vec3 place, double& square, const RangeOf& range_of, Look&& look) const;

 private:
  static constexpr std::size_t kFan = 4;
  struct Level {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<HeightRange> ranges;
  };
  struct Block {
    std::size_t i;
    std::size_t j;
    double square;
  };

  [[nodiscard]] double square(Vec3 place, std::size_t level, std::size_t i, std::size_t j,
                              HeightRange range) const;
  template <class Look>
  void visit(Vec3 place, double& best, const RangeOf& range_of, Look& look, std::size_t level,
             std::size_t i, std::size_t j) const;

  const std::vector<double>* x_ = nullptr;
  const std::vector<double>* y_ = nullptr;
  std::vector<Level> levels_;  // 0: blocks of cells; the last has one block
};

template <class Look>
void Skin::search(Vec3 place, double& square, const RangeOf& range_of, Look&& look) const {
  if (levels_.empty()) return;
  visit(place, square, range_of, look, levels_.size(), 0, 0);
}

template <class Look>
void Skin::visit(Vec3 place, double& best, const RangeOf& range_of, Look& look, std::size_t level,
                 std::size_t i, std::size_t j) const {
  const bool is_cells = level == 0;
  const std::size_t columns = is_cells ? x_->size() - 1 : levels_[level - 1].columns;
  const std::size_t rows = is_cells ? y_->size() - 1 : levels_[level - 1].rows;
  std::array<Block, kFan * kFan> inner;
  std::size_t count = 0;
  const bool is_top = level == levels_.size();
  const std::size_t end_i = is_top ? columns : std::min(columns, (i + 1) * kFan);
  const std::size_t end_j = is_top ? rows : std::min(rows, (j + 1) * kFan);
  for (std::size_t b = is_top ? 0 : j * kFan; b < end_j; ++b) {
    for (std::size_t a = is_top ? 0 : i * kFan; a < end_i; ++a) {
      const HeightRange range =
          is_cells ? range_of({a, b}) : levels_[level - 1].ranges[b * columns + a];
      if (range.is_none()) continue;
      const Block block{a, b, square(place, level, a, b, range)};
      std::size_t at = count++;
      for (; at > 0 && inner[at - 1].square > block.square; --at) inner[at] = inner[at - 1];
      inner[at] = block;
    }
  }
  for (std::size_t k = 0; k < count && inner[k].square <= best; ++k) {
    if (is_cells) {
      look(Cell{inner[k].i, inner[k].j}, best);
    } else {
      visit(place, best, range_of, look, level - 1, inner[k].i, inner[k].j);
    }
  }
}

}  // namespace kerf::stock::compare
