#include "stock/sheet/internal/tile_list.hpp"

#include <algorithm>

namespace kerf::stock::sheet {
namespace {

constexpr int kNumberBits = 32;

int tile_at(double offset, double cell, int tiles) {
  const double tile = std::floor(offset / (cell * kTileSide));
  return static_cast<int>(std::clamp(tile, 0.0, static_cast<double>(tiles - 1)));
}

}  // namespace

int TileList::tile_x(double x) const {
  return tile_at(x - grid_.box.low.u, grid_.cell_x(), grid_.tiles_x());
}

int TileList::tile_y(double y) const {
  return tile_at(y - grid_.box.low.v, grid_.cell_y(), grid_.tiles_y());
}

Vec2 TileList::middle(const Range& range) const {
  const double i = 0.5 * (range.i0 + range.i1 + 1) * kTileSide;
  const double j = 0.5 * (range.j0 + range.j1 + 1) * kTileSide;
  return grid_.box.low + Vec2{i * grid_.cell_x(), j * grid_.cell_y()};
}

double TileList::half_diagonal(const Range& range) const {
  const double u = 0.5 * (range.i1 - range.i0 + 1) * kTileSide * grid_.cell_x();
  const double v = 0.5 * (range.j1 - range.j0 + 1) * kTileSide * grid_.cell_y();
  return std::sqrt(u * u + v * v);
}

void TileList::put(const Range& tile) {
  const std::uint64_t place =
      static_cast<std::uint64_t>(tile.j0) * static_cast<std::uint64_t>(grid_.tiles_x()) +
      static_cast<std::uint64_t>(tile.i0);
  keys_.push_back(place << kNumberBits | number_);
}

std::vector<TileList::Run> TileList::runs() {
  std::sort(keys_.begin(), keys_.end());
  std::vector<Run> runs;
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    const std::size_t tile = keys_[i] >> kNumberBits;
    if (runs.empty() || runs.back().tile != tile) runs.push_back({tile, i, i});
    runs.back().end = i + 1;
  }
  return runs;
}

}  // namespace kerf::stock::sheet
