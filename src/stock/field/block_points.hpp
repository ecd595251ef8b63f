#pragma once

#include <array>
#include <cstddef>

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

/// A box that is larger by so much to all sides, seen from above.
[[nodiscard]] inline Bounds around(const Bounds& box, double reach) {
  const Vec3 by{reach, reach, 0};
  return {box.low - by, box.high + by};
}

/// How far columns are from the middle of those of their block, mm.
struct HalfBlock {
  double x = 0;
  double y = 0;
};

/// Blocks of a tile, those of some columns and rows of them: the middles of their columns, how far
/// columns are from them, and the highest material of each.
struct BlockGrid {
  const float* x;  ///< kTileBlocks of them, from origin_x
  const double* y;
  const float* tops;  ///< by rows along X
  double origin_x = 0;
  HalfBlock half;
  std::size_t first_x = 0;
  std::size_t end_x = kTileBlocks;
  std::size_t first_y = 0;
  std::size_t end_y = kTileBlocks;
};

/// Some blocks of a tile: bit i of number j is block i of row j.
using BlockMasks = std::array<unsigned, kTileBlocks>;

}  // namespace kerf::stock::field
