#include "stock/sheet/internal/tile_painter.hpp"

#include <numbers>

namespace kerf::stock::sheet {
namespace {

// Blocks are passed over whole where the way is too far.
constexpr int kBlock = 8;

/// The share of a cell that a kerf covers, as a function of its middle's distance from the way.
class Rule {
 public:
  Rule(double kerf, double cell)
      : near_(kFull * (0.5 + kerf / 2 / cell)),
        far_(kFull * (0.5 - kerf / 2 / cell)),
        slope_(kFull / cell) {}
  [[nodiscard]] std::uint8_t operator()(double distance) const {
    const double steep = slope_ * distance;
    const double covered = clamped(near_ - steep) - clamped(far_ - steep);
    return static_cast<std::uint8_t>(static_cast<int>(covered + 0.5));
  }

 private:
  static constexpr double kFull = 255;
  [[nodiscard]] static double clamped(double value) {
    value = value < 0 ? 0 : value;
    return value > kFull ? kFull : value;
  }
  double near_, far_, slope_;
};

/// Which share of its way a spot is over a place.
class SpotOver {
 public:
  SpotOver(const Burn& burn, double spot)
      : from_(burn.from), way_(burn.to - burn.from), square_radius_(spot * spot / 4) {
    const double square = dot(way_, way_);
    stands_ = square < kStands_mm2;
    inverse_ = stands_ ? 0 : 1 / square;
  }
  [[nodiscard]] double operator()(double x, double y) const {
    const double u = x - from_.u;
    const double v = y - from_.v;
    if (stands_) return u * u + v * v <= square_radius_ ? 1 : 0;
    const double across = u * way_.v - v * way_.u;
    const double square = (square_radius_ - across * across * inverse_) * inverse_;
    if (!(square > 0)) return 0;
    const double half = std::sqrt(square);
    const double along = (u * way_.u + v * way_.v) * inverse_;
    return std::max(0.0, std::min(1.0, along + half) - std::max(0.0, along - half));
  }

 private:
  static constexpr double kStands_mm2 = 1e-18;
  Vec2 from_;
  Vec2 way_;
  double square_radius_;
  double inverse_ = 0;
  bool stands_ = false;
};

/// The cells with their middle between two places, of `count`.
struct Cells {
  int first;
  int end;
};
Cells cells_between(double low, double high, double from, double cell, int count) {
  const auto at = [&](double place) { return std::clamp(place, 0.0, static_cast<double>(count)); };
  const double first = std::ceil((low - from) / cell - 0.5);
  const double last = std::floor((high - from) / cell - 0.5);
  return {static_cast<int>(at(first)), static_cast<int>(at(last + 1))};
}

std::size_t index(int i, int j) { return static_cast<std::size_t>(j * kTileSide + i); }

}  // namespace

TilePainter::TilePainter(const Grid& grid, std::size_t tile)
    : cell_(grid.cell()), cell_x_(grid.cell_x()), cell_y_(grid.cell_y()) {
  const auto row = static_cast<std::size_t>(grid.tiles_x());
  const int i0 = static_cast<int>(tile % row) * kTileSide;
  const int j0 = static_cast<int>(tile / row) * kTileSide;
  nx_ = std::min(kTileSide, grid.nx - i0);
  ny_ = std::min(kTileSide, grid.ny - j0);
  low_x_ = grid.box.low.u + i0 * cell_x_;
  low_y_ = grid.box.low.v + j0 * cell_y_;
  half_block_ = 0.5 * kBlock * std::sqrt(cell_x_ * cell_x_ + cell_y_ * cell_y_);
  for (int n = 0; n < kTileSide; ++n) {
    x_[static_cast<std::size_t>(n)] = grid.x(i0 + n);
    y_[static_cast<std::size_t>(n)] = grid.y(j0 + n);
  }
}

TilePainter::Range TilePainter::cells_in(const Box& box) const {
  const Cells along_x = cells_between(box.low.u, box.high.u, low_x_, cell_x_, nx_);
  const Cells along_y = cells_between(box.low.v, box.high.v, low_y_, cell_y_, ny_);
  return {along_x.first, along_x.end, along_y.first, along_y.end};
}

Vec2 TilePainter::middle(const Range& block) const {
  return {low_x_ + 0.5 * (block.i0 + block.i1) * cell_x_,
          low_y_ + 0.5 * (block.j0 + block.j1) * cell_y_};
}

void TilePainter::cut(const Trace& trace, double kerf_mm, Sheet::Coverage& cells) const {
  const Range range = cells_in(extents(trace).grown((kerf_mm + cell_) / 2));
  if (range.is_empty()) return;
  if (trace.radius > 0) {
    cover(DistanceToArc(trace), range, kerf_mm, cells);
  } else {
    cover(DistanceToLine(trace.from, trace.to), range, kerf_mm, cells);
  }
}

template <typename Distance>
void TilePainter::cover(const Distance& distance, const Range& range, double kerf_mm,
                        Sheet::Coverage& cells) const {
  const double reach = (kerf_mm + cell_) / 2 + half_block_;
  for (int j = range.j0; j < range.j1; j += kBlock) {
    for (int i = range.i0; i < range.i1; i += kBlock) {
      const Range block{i, std::min(i + kBlock, range.i1), j, std::min(j + kBlock, range.j1)};
      const Vec2 at = middle(block);
      if (distance(at.u, at.v) <= reach) cover_block(distance, block, kerf_mm, cells);
    }
  }
}

template <typename Distance>
void TilePainter::cover_block(const Distance& distance, const Range& block, double kerf_mm,
                              Sheet::Coverage& cells) const {
  const Rule rule(kerf_mm, cell_);
  for (int j = block.j0; j < block.j1; ++j) {
    const double y = y_[static_cast<std::size_t>(j)];
    for (int i = block.i0; i < block.i1; ++i) {
      std::uint8_t& cell = cells[index(i, j)];
      cell = std::max(cell, rule(distance(x_[static_cast<std::size_t>(i)], y)));
    }
  }
}

void TilePainter::burn(const Burn& burn, double spot_mm, Sheet::Energy& cells) const {
  Box box;
  box.take(burn.from);
  box.take(burn.to);
  const Range range = cells_in(box.grown(spot_mm / 2));
  const SpotOver share(burn, spot_mm);
  const double density = burn.energy_j / (std::numbers::pi / 4 * spot_mm * spot_mm);
  for (int j = range.j0; j < range.j1; ++j) {
    const double y = y_[static_cast<std::size_t>(j)];
    for (int i = range.i0; i < range.i1; ++i) {
      cells[index(i, j)] += static_cast<float>(density * share(x_[static_cast<std::size_t>(i)], y));
    }
  }
}

}  // namespace kerf::stock::sheet
