#pragma once

#include "stock/dexel/glance.hpp"
#include "stock/dexel/hulls.hpp"
#include "stock/dexel/lattice.hpp"
#include "stock/dexel/posed_tool.hpp"
#include "stock/dexel/strokes.hpp"
#include "stock/dexel/tile.hpp"

namespace kerf::stock::dexel {

/// A tile in its lattice.
struct TilePlace {
  const Lattice& lattice;
  int first_column;
  int first_row;

  [[nodiscard]] double b_of(int column) const { return lattice.b_of(first_column + column); }
  [[nodiscard]] double c_of(int row) const { return lattice.c_of(first_row + row); }
};

/// What of a tile lies in a box, and may be met there, before anything is computed exactly.
class TileWindow {
 public:
  /// What is asked is the tile's when it is asked; both outlive this.
  TileWindow(const TilePlace& place, const Tile& tile, const Bounds& box);

  [[nodiscard]] const CellRange& columns() const { return columns_; }
  [[nodiscard]] const CellRange& rows() const { return rows_; }
  [[nodiscard]] std::uint64_t parts() const { return parts_; }
  // Along the dexels.
  [[nodiscard]] float low() const { return low_; }
  [[nodiscard]] float high() const { return high_; }

  [[nodiscard]] bool is_empty() const {
    return columns_.first > columns_.last || rows_.first > rows_.last;
  }
  /// Nothing of a solid reaches dexels of the stock, not even where blocks are looked at. Asked of
  /// balls, and along the axis: elsewhere Passage::may_meet() itself may say yes.
  [[nodiscard]] bool is_beside(const PosedSolid& solid, const Frame& frame,
                               const Stroke& stroke) const;
  /// What a glance at lines so many dexels apart is asked for, in here and by `margin_mm` around.
  [[nodiscard]] Glance::Lines lines(double margin_mm, int dexels_apart) const;
  /// At the dexels of a block's row. Only of those that are in one piece there it is sure.
  [[nodiscard]] Glance::Answer at_row(const Glance& near, Hulls& hulls, int column, int row) const;
  /// At four blocks, of which the first is at `column`. Null: there is no glance that knows more.
  [[nodiscard]] Glance::Answer at_blocks(const Glance* far, int column, int row) const;
  /// At four blocks of a tile, with material in these parts: those that may be met.
  [[nodiscard]] static unsigned at_blocks(const TilePlace& place, const Tile& tile,
                                          const Glance& far, int column, int row,
                                          std::uint64_t parts);

 private:
  TilePlace place_;
  const Tile& tile_;
  CellRange columns_;
  CellRange rows_;
  std::uint64_t parts_;
  float low_;
  float high_;
};

}  // namespace kerf::stock::dexel
