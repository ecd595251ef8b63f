#pragma once

#include <cstddef>
#include <cstdint>

#include "stock/sheet/trace.hpp"

namespace kerf::stock::sheet {

inline constexpr int kTileSide = 64;  ///< cells along a side of a tile
inline constexpr int kTileCells = kTileSide * kTileSide;

/// Cells that fill a rectangle: nx × ny of them, nx along X.
struct Grid {
  Box box;
  int nx = 1;
  int ny = 1;

  [[nodiscard]] double cell_x() const { return (box.high.u - box.low.u) / nx; }
  [[nodiscard]] double cell_y() const { return (box.high.v - box.low.v) / ny; }
  [[nodiscard]] double cell_mm2() const { return cell_x() * cell_y(); }
  /// h of stock.md §4.7: both sides of a cell are the same but for what it takes to fill the box.
  [[nodiscard]] double cell() const { return (cell_x() + cell_y()) / 2; }
  /// The middle of a cell.
  [[nodiscard]] double x(int i) const { return box.low.u + (i + 0.5) * cell_x(); }
  [[nodiscard]] double y(int j) const { return box.low.v + (j + 0.5) * cell_y(); }
  [[nodiscard]] int tiles_x() const { return (nx + kTileSide - 1) / kTileSide; }
  [[nodiscard]] int tiles_y() const { return (ny + kTileSide - 1) / kTileSide; }
  [[nodiscard]] std::size_t tiles() const {
    return static_cast<std::size_t>(tiles_x()) * static_cast<std::size_t>(tiles_y());
  }
};

/// Cells not larger than this that fill the box exactly (stock.md §3): n = ⌈L / cell - 1e-9⌉, at
/// least 1. Precondition: the box has a size along each axis, and neither n exceeds kMostCells.
[[nodiscard]] Grid grid_of(const Box& box, double cell_mm);

/// The most cells along an axis.
inline constexpr double kMostCells = 1 << 26;

/// `cell_mm`, or as much more as it takes that neither axis has too many cells and that what stands
/// for each tile, touched or not, fits into a quarter of the memory.
[[nodiscard]] double fitting_cell(const Box& box, double cell_mm, std::size_t memory_bytes);

}  // namespace kerf::stock::sheet
