#pragma once

#include <array>

#include "stock/field/grid.hpp"

namespace kerf::stock::field {

// Floats, relative to a place on the way: four at once fit a register of every processor, and
// within kLongestLeg_mm they are 100 times finer than the error bound of sweeps.

/// A value for each column of a block, row by row.
using BlockValues = std::array<float, kBlockCells>;
/// A value for each block of a row of a tile.
using RowValues = std::array<float, kTileBlocks>;

/// Longer ways are divided, wider arcs become chords.
inline constexpr double kLongestLeg_mm = 1000;

/// Where the columns of a block stand: x of its columns, y of its rows, kBlockSide each.
struct BlockPoints {
  const double* x;
  const double* y;

  [[nodiscard]] double x_of(std::size_t i) const { return x[i % kBlockSide]; }
  [[nodiscard]] double y_of(std::size_t i) const { return y[i / kBlockSide]; }
};

/// A row of blocks of a tile: the middles of their columns, and how far columns are from them
/// along X and Y.
struct BlockRow {
  const double* x;  // kTileBlocks of them
  double y = 0;
  double half_x = 0;
  double half_y = 0;
};

}  // namespace kerf::stock::field
