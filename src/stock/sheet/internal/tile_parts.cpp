#include "stock/sheet/internal/tile_parts.hpp"

namespace kerf::stock::sheet {

TileParts::TileParts(const Sheet::Coverage& cells, int nx, int ny, std::uint8_t cut_from)
    : nx_(nx), ny_(ny) {
  labels_.fill(kNone);
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) fill(cells, j * kTileSide + i, cut_from);
  }
}

void TileParts::fill(const Sheet::Coverage& cells, int cell, std::uint8_t cut_from) {
  if (at(cell) != kNone || cells[static_cast<std::size_t>(cell)] >= cut_from) return;
  parts_.emplace_back();
  parts_.back().first = cell;
  visit(cells, cell, cut_from);
  while (!waiting_.empty()) {
    const int next = waiting_.back();
    waiting_.pop_back();
    const int i = next % kTileSide;
    const int j = next / kTileSide;
    if (i > 0) visit(cells, next - 1, cut_from);
    if (i + 1 < nx_) visit(cells, next + 1, cut_from);
    if (j > 0) visit(cells, next - kTileSide, cut_from);
    if (j + 1 < ny_) visit(cells, next + kTileSide, cut_from);
  }
}

void TileParts::visit(const Sheet::Coverage& cells, int cell, std::uint8_t cut_from) {
  const auto place = static_cast<std::size_t>(cell);
  if (labels_[place] != kNone || cells[place] >= cut_from) return;
  labels_[place] = static_cast<std::uint16_t>(parts_.size() - 1);
  TilePart& part = parts_.back();
  const int i = cell % kTileSide;
  const int j = cell / kTileSide;
  part.left += 255U - cells[place];
  part.i0 = std::min(part.i0, i);
  part.i1 = std::max(part.i1, i);
  part.j0 = std::min(part.j0, j);
  part.j1 = std::max(part.j1, j);
  if (i == 0 || j == 0 || i + 1 == nx_ || j + 1 == ny_) part.is_closed = false;
  waiting_.push_back(cell);
}

}  // namespace kerf::stock::sheet
