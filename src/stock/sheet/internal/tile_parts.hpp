#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "stock/sheet/sheet.hpp"

namespace kerf::stock::sheet {

/// Cells of a tile that hang together, in the numbers of the tile.
struct TilePart {
  std::uint64_t left = 0;                                ///< Σ 255 - coverage
  int i0 = kTileSide, i1 = -1, j0 = kTileSide, j1 = -1;  ///< both ends included
  int first = 0;                                         ///< its first cell
  bool is_closed = true;                                 ///< touches no edge of the tile
};

/// The 4-connected parts of one tile's cells below `cut_from`.
class TileParts {
 public:
  /// `nx`, `ny`: cells of the tile that are in the grid.
  TileParts(const Sheet::Coverage& cells, int nx, int ny, std::uint8_t cut_from);

  static constexpr std::uint16_t kNone = 0xffff;
  /// The number of a cell's part, or kNone.
  [[nodiscard]] std::uint16_t at(int cell) const { return labels_[static_cast<std::size_t>(cell)]; }
  [[nodiscard]] const std::vector<TilePart>& parts() const { return parts_; }

 private:
  void fill(const Sheet::Coverage& cells, int cell, std::uint8_t cut_from);
  void visit(const Sheet::Coverage& cells, int cell, std::uint8_t cut_from);

  int nx_, ny_;
  std::array<std::uint16_t, kTileCells> labels_;
  std::vector<TilePart> parts_;
  std::vector<int> waiting_;
};

}  // namespace kerf::stock::sheet
