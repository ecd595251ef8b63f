#pragma once

#include <cstddef>
#include <cstdint>

#include "stock/sweep/way.hpp"

namespace kerf::stock::field {

inline constexpr int kBlockSide = 4;    ///< columns along a side of a block
inline constexpr int kBlockCells = 16;  ///< columns in a block: one line of the cache
inline constexpr int kTileBlocks = 16;  ///< blocks along a side of a tile
inline constexpr int kTileSide = 64;    ///< columns along a side of a tile
inline constexpr int kTileCells = kTileSide * kTileSide;

/// Columns that fill a box: nx × ny of them, each along Z through the centre of its cell.
struct Grid {
  Bounds box;
  int nx = 1;
  int ny = 1;

  [[nodiscard]] double cell_x() const { return (box.high.x - box.low.x) / nx; }
  [[nodiscard]] double cell_y() const { return (box.high.y - box.low.y) / ny; }
  /// Centres lie exactly as far from the middle of the box as those opposite to them.
  [[nodiscard]] double x(int i) const {
    return (box.low.x + box.high.x) / 2 + (2 * i + 1 - nx) * (cell_x() / 2);
  }
  [[nodiscard]] double y(int j) const {
    return (box.low.y + box.high.y) / 2 + (2 * j + 1 - ny) * (cell_y() / 2);
  }
  [[nodiscard]] int tiles_x() const { return (nx + kTileSide - 1) / kTileSide; }
  [[nodiscard]] int tiles_y() const { return (ny + kTileSide - 1) / kTileSide; }
  [[nodiscard]] std::size_t tiles() const {
    return static_cast<std::size_t>(tiles_x()) * static_cast<std::size_t>(tiles_y());
  }
  friend bool operator==(const Grid&, const Grid&) = default;
};

/// Cells not larger than this that fill the box exactly (stock.md §3): n = ⌈L / cell - 1e-9⌉, at
/// least 1. Precondition: the box has a size along each axis, and neither n exceeds 2²⁶.
[[nodiscard]] Grid grid_of(const Bounds& box, double cell_mm);

/// By how much a swept surface may be wrong: min(1 µm, h / 100), for ways that are divided.
[[nodiscard]] double sweep_error_mm(const Grid& grid);

}  // namespace kerf::stock::field
