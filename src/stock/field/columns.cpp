#include "stock/field/columns.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::stock::field {
namespace {

constexpr std::size_t kCells = kTileCells;
constexpr std::size_t kBlocks = kTileBlocks * kTileBlocks;

/// Of a column in its tile.
std::size_t cell_in_tile(int i, int j) {
  const int block = (j / kBlockSide) * kTileBlocks + i / kBlockSide;
  return static_cast<std::size_t>(block * kBlockCells + (j % kBlockSide) * kBlockSide +
                                  i % kBlockSide);
}

}  // namespace

Columns::Columns(const Grid& grid)
    : Columns(grid, [&box = grid.box](double, double) {
        return Column{box.low.z, box.high.z};
      }) {
  bottoms_.clear();
  bottoms_.shrink_to_fit();
}

Columns::Columns(const Grid& grid, const ColumnAt& column_at) : Columns(grid, Bottoms::stored) {
  fill(column_at);
}

Columns::Columns(const FieldState& state)
    : Columns(state.grid, state.bottoms.empty() ? Bottoms::all_zero : Bottoms::stored) {
  std::size_t from = 0;
  for (int j = 0; j < grid_.ny; ++j) {
    for (int i = 0; i < grid_.nx; ++i, ++from) {
      heights_[at(i, j)] = state.heights[from];
      if (has_bottoms()) bottoms_[at(i, j)] = state.bottoms[from];
    }
  }
  for (std::size_t tile = 0; tile < grid_.tiles(); ++tile) see_tops(tile);
}

Columns::Columns(const Grid& grid, Bottoms bottoms)
    : grid_(grid),
      heights_(grid.tiles() * kCells),
      owners_(grid.tiles() * kCells),
      bottoms_(bottoms == Bottoms::stored ? grid.tiles() * kCells : 0),
      block_tops_(grid.tiles() * kBlocks),
      tops_(grid.tiles()),
      versions_(grid.tiles()) {
  for (int i = 0; i < grid.tiles_x() * kTileSide; ++i) x_.push_back(grid.x(i));
  for (int j = 0; j < grid.tiles_y() * kTileSide; ++j) y_.push_back(grid.y(j));
}

void Columns::fill(const ColumnAt& column_at) {
  const double low = grid_.box.low.z;
  const double size = grid_.box.high.z - low;
  for (int j = 0; j < grid_.ny; ++j) {
    for (int i = 0; i < grid_.nx; ++i) {
      const Column column = column_at(grid_.x(i), grid_.y(j));
      const auto bottom = static_cast<float>(std::clamp(column.bottom - low, 0.0, size));
      const auto top = static_cast<float>(std::clamp(column.top - low, 0.0, size));
      bottoms_[at(i, j)] = bottom;
      heights_[at(i, j)] = std::max(bottom, top);
    }
  }
  for (std::size_t tile = 0; tile < grid_.tiles(); ++tile) see_tops(tile);
}

std::size_t Columns::at(int i, int j) const {
  const int tile = (j / kTileSide) * grid_.tiles_x() + i / kTileSide;
  return static_cast<std::size_t>(tile) * kCells + cell_in_tile(i % kTileSide, j % kTileSide);
}

Columns::Tile Columns::tile(std::size_t index) {
  const auto across = static_cast<std::size_t>(grid_.tiles_x());
  return {heights_.data() + index * kCells,
          owners_.data() + index * kCells,
          block_tops_.data() + index * kBlocks,
          bottoms_.empty() ? nullptr : bottoms_.data() + index * kCells,
          x_.data() + index % across * kTileSide,
          y_.data() + index / across * kTileSide};
}

BlockValues Columns::tops(std::size_t tile, int block) const {
  BlockValues tops;
  const std::size_t first = tile * kCells + static_cast<std::size_t>(block) * kBlockCells;
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    const float bottom = bottoms_.empty() ? 0 : bottoms_[first + i];
    const float height = heights_[first + i];
    tops[i] = height > bottom ? height : -1.0F;
  }
  return tops;
}

double Columns::block_top(std::size_t tile, int block) const {
  return static_cast<double>(block_tops_[tile * kBlocks + static_cast<std::size_t>(block)]);
}

void Columns::changed(std::size_t tile, std::uint64_t times) {
  const float* tops = block_tops_.data() + tile * kBlocks;
  tops_[tile] = static_cast<double>(*std::max_element(tops, tops + kBlocks));
  versions_[tile] += times;
}

void Columns::see_tops(std::size_t tile) {
  for (std::size_t block = 0; block < kBlocks; ++block) {
    const std::size_t first = tile * kCells + block * kBlockCells;
    float top = 0;
    for (std::size_t i = first; i < first + kBlockCells; ++i) {
      const float bottom = bottoms_.empty() ? 0 : bottoms_[i];
      if (heights_[i] > bottom) top = std::max(top, heights_[i]);
    }
    block_tops_[tile * kBlocks + block] = top;
  }
  changed(tile, 0);
}

TileState Columns::state(std::size_t tile) const {
  const auto first = static_cast<std::ptrdiff_t>(tile * kCells);
  const auto last = first + static_cast<std::ptrdiff_t>(kCells);
  return {{heights_.begin() + first, heights_.begin() + last},
          {owners_.begin() + first, owners_.begin() + last}};
}

void Columns::restore(std::size_t tile, const TileState& state) {
  const auto first = static_cast<std::ptrdiff_t>(tile * kCells);
  std::copy(state.heights.begin(), state.heights.end(), heights_.begin() + first);
  std::copy(state.owners.begin(), state.owners.end(), owners_.begin() + first);
  see_tops(tile);
  ++versions_[tile];
}

double Columns::volume_mm3() const {
  double sum = 0;
  for (std::size_t tile = 0; tile < grid_.tiles(); ++tile) {
    double heights = 0;
    for (std::size_t i = tile * kCells; i < (tile + 1) * kCells; ++i) {
      const float bottom = bottoms_.empty() ? 0 : bottoms_[i];
      heights += static_cast<double>(heights_[i]) - static_cast<double>(bottom);
    }
    sum += heights;
  }
  return sum * grid_.cell_x() * grid_.cell_y();
}

double Columns::error_mm3() const {
  double steps = 0;
  const auto step = [&](int i, int j, int i2, int j2) {
    if (i2 >= grid_.nx || j2 >= grid_.ny || (owner(i, j) == 0 && owner(i2, j2) == 0)) return;
    steps += std::abs(static_cast<double>(height(i, j)) - static_cast<double>(height(i2, j2)));
  };
  for (int j = 0; j < grid_.ny; ++j) {
    for (int i = 0; i < grid_.nx; ++i) {
      step(i, j, i + 1, j);
      step(i, j, i, j + 1);
    }
  }
  // A step along X has the area |Δh| cell_y, and half a cell_x across it; one along Y the opposite.
  return steps * grid_.cell_x() * grid_.cell_y() / 2;
}

Bounds Columns::extents() const {
  constexpr int kFar = 1 << 30;
  int i0 = kFar, i1 = -1, j0 = kFar, j1 = -1;
  float low = static_cast<float>(kFar), high = -1;
  for (int j = 0; j < grid_.ny; ++j) {
    for (int i = 0; i < grid_.nx; ++i) {
      if (height(i, j) <= bottom(i, j)) continue;
      i0 = std::min(i0, i), i1 = std::max(i1, i), j0 = std::min(j0, j), j1 = j;
      low = std::min(low, bottom(i, j)), high = std::max(high, height(i, j));
    }
  }
  if (i1 < 0) return {{1, 1, 1}, {-1, -1, -1}};
  const double hx = grid_.cell_x() / 2;
  const double hy = grid_.cell_y() / 2;
  const double z = grid_.box.low.z;
  return {{grid_.x(i0) - hx, grid_.y(j0) - hy, z + static_cast<double>(low)},
          {grid_.x(i1) + hx, grid_.y(j1) + hy, z + static_cast<double>(high)}};
}

std::size_t Columns::bytes() const {
  const auto held = [](const auto& v) { return v.capacity() * sizeof v[0]; };
  return held(heights_) + held(owners_) + held(bottoms_) + held(block_tops_) + held(tops_) +
         held(versions_) + held(x_) + held(y_);
}

}  // namespace kerf::stock::field
