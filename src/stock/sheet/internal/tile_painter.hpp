#pragma once

#include "stock/sheet/sheet.hpp"

namespace kerf::stock::sheet {

/// Does traces and burns to the cells of one tile.
class TilePainter {
 public:
  TilePainter(const Grid& grid, std::size_t tile);

  void cut(const Trace& trace, double kerf_mm, Sheet::Coverage& cells) const;
  void burn(const Burn& burn, double spot_mm, Sheet::Energy& cells) const;

 private:
  /// Cells of the tile, ends not included.
  struct Range {
    int i0, i1, j0, j1;
    [[nodiscard]] bool is_empty() const { return i0 >= i1 || j0 >= j1; }
  };

  /// Those whose middle is in the box.
  [[nodiscard]] Range cells_in(const Box& box) const;
  [[nodiscard]] Vec2 middle(const Range& block) const;
  template <typename Distance>
  void cover(const Distance& distance, const Range& range, double kerf_mm,
             Sheet::Coverage& cells) const;
  template <typename Distance>
  void cover_block(const Distance& distance, const Range& block, double kerf_mm,
                   Sheet::Coverage& cells) const;

  double cell_;
  double half_block_;  // from the middle of a block to its corners
  int nx_, ny_;        // cells of the tile that are in the grid
  double cell_x_, cell_y_;
  double low_x_, low_y_;  // of the tile
  std::array<double, kTileSide> x_, y_;
};

}  // namespace kerf::stock::sheet
