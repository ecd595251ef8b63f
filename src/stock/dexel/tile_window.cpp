#include "stock/dexel/tile_window.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::stock::dexel {
namespace {

constexpr int kSide = Tile::kBlock;
constexpr double kMore_mm = 0.01;

CellRange in_tile(CellRange all, int first, int count) {
  return {std::max(all.first - first, 0), std::min(all.last - first, count - 1)};
}

/// Of four, both ends included.
unsigned bits_between(int first, int last) {
  const auto from = static_cast<unsigned>(std::clamp(first, 0, 4));
  const auto after = static_cast<unsigned>(std::clamp(last + 1, 0, 4));
  return from < after ? (1U << after) - (1U << from) : 0;
}

}  // namespace

TileWindow::TileWindow(const TilePlace& place, const Tile& tile, const Bounds& box)
    : place_(place), tile_(tile) {
  const Lattice& lattice = place.lattice;
  const int a = lattice.axis;
  const int b = (a + 1) % 3;
  const int c = (a + 2) % 3;
  columns_ = in_tile(lattice.columns_in(on_axis(box.low, b), on_axis(box.high, b)),
                     place.first_column, tile.columns());
  rows_ = in_tile(lattice.rows_in(on_axis(box.low, c), on_axis(box.high, c)), place.first_row,
                  tile.rows());
  parts_ = tile.parts(on_axis(box.low, a), on_axis(box.high, a));
  low_ = static_cast<float>(on_axis(box.low, a));
  high_ = static_cast<float>(on_axis(box.high, a));
}

bool TileWindow::is_beside(const PosedSolid& solid, const Frame& frame,
                           const Stroke& stroke) const {
  const int axis = place_.lattice.axis;
  const bool is_along = std::fabs(on_axis(frame.up, axis)) == 1;
  if (!is_along && !solid.solid.is_whole_ball()) return false;
  const double half = place_.lattice.half_s * (1 + 1e-6);
  const double from = on_axis(stroke.from, axis);
  const double to = from + on_axis(stroke.way, axis);
  return std::min(from, to) + on_axis(solid.around_reach.low, axis) > half ||
         std::max(from, to) + on_axis(solid.around_reach.high, axis) < -half;
}

Glance::Lines TileWindow::lines(double margin_mm, int dexels_apart) const {
  const Lattice& lattice = place_.lattice;
  const double more = margin_mm + kMore_mm + lattice.half_s / 32;  // and a part of a block
  const double b = (kSide + Glance::kLines * dexels_apart) * lattice.cell_b;
  const double c = kSide * lattice.cell_c;
  const Vec3 low{std::max(double{low_}, -lattice.half_s) - more, place_.b_of(columns_.first) - b,
                 place_.c_of(rows_.first) - c};
  const Vec3 high{std::min(double{high_}, lattice.half_s) + more, place_.b_of(columns_.last) + b,
                  place_.c_of(rows_.last) + c};
  return {lattice.axis, dexels_apart * lattice.cell_b, {low, high}};
}

Glance::Answer TileWindow::at_row(const Glance& near, Hulls& hulls, int column, int row) const {
  const Hulls::Four& four = hulls.four(column, row);
  const Glance::Answer answer =
      near.may_meet(place_.b_of(column), place_.c_of(row), near.offsets(four.low, low_, true),
                    near.offsets(four.high, high_, false));
  const unsigned here = bits_between(columns_.first - column, columns_.last - column);
  return {answer.may & here, answer.surely & here & four.single};
}

Glance::Answer TileWindow::at_blocks(const Glance* far, int column, int row) const {
  constexpr double kMiddle = 0.5 * (kSide - 1);
  Glance::Four low{1, 1, 1, 1};
  Glance::Four high{-1, -1, -1, -1};
  unsigned bits = 0;
  for (int i = 0; i < Glance::kLines && column + i * kSide <= columns_.last; ++i) {
    const std::uint64_t parts = tile_.block_parts(column + i * kSide, row) & parts_;
    if (parts == 0) continue;
    bits |= 1U << static_cast<unsigned>(i);
    if (far == nullptr) continue;
    const Tile::Stretch stretch = tile_.stretch(parts);
    low[i] = far->offset(double{stretch.low});
    high[i] = far->offset(double{stretch.high});
  }
  if (far == nullptr || bits == 0) return {bits, 0};
  return far->may_meet(place_.b_of(column) + kMiddle * place_.lattice.cell_b,
                       place_.c_of(row) + kMiddle * place_.lattice.cell_c, low, high);
}

unsigned TileWindow::at_blocks(const TilePlace& place, const Tile& tile, const Glance& far,
                               int column, int row, std::uint64_t parts) {
  constexpr double kMiddle = 0.5 * (kSide - 1);
  Glance::Four low{1, 1, 1, 1};
  Glance::Four high{-1, -1, -1, -1};
  bool any = false;
  for (int i = 0; i < Glance::kLines && column + i * kSide < tile.columns(); ++i) {
    const std::uint64_t met = tile.block_parts(column + i * kSide, row) & parts;
    if (met == 0) continue;
    any = true;
    const Tile::Stretch stretch = tile.stretch(met);
    low[i] = far.offset(double{stretch.low});
    high[i] = far.offset(double{stretch.high});
  }
  if (!any) return 0;
  return far
      .may_meet(place.b_of(column) + kMiddle * place.lattice.cell_b,
                place.c_of(row) + kMiddle * place.lattice.cell_c, low, high)
      .may;
}

}  // namespace kerf::stock::dexel
