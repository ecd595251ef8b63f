#pragma once

#include <array>

#include "stock/field/grid.hpp"

namespace kerf::stock::field {

/// A value for each column of a block, row by row.
using BlockValues = std::array<double, kBlockCells>;

/// Where the columns of a block stand, mm.
struct BlockPoints {
  BlockValues x;
  BlockValues y;
};

/// A row of blocks of a tile: the middles of their columns, and how far columns are from them.
struct BlockRow {
  std::array<double, kTileBlocks> x;
  double y = 0;
  double radius = 0;
};
/// A value for each block of a row.
using RowValues = std::array<double, kTileBlocks>;

}  // namespace kerf::stock::field
