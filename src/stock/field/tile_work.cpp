#include "stock/field/tile_work.hpp"

#include <algorithm>
#include <cmath>

#include "base/each_by_threads.hpp"
#include "stock/field/tile_cutter.hpp"

namespace kerf::stock::field {
namespace {

/// Threads take longer to begin than so many columns to cut.
constexpr double kWorthThreads = 200000;

int tile_of(double at, double low, double cell, int tiles) {
  const double tile = std::floor((at - low) / (cell * kTileSide));
  return static_cast<int>(std::clamp(tile, -1.0, static_cast<double>(tiles)));
}

/// How far from its tip a tool may do something: beyond the edges only where another part comes
/// down to the stock.
double reach_of(const ReadySweep& sweep, double stock_top) {
  double reach = sweep.tool->edge_reach;
  for (const FieldTool::Part& part : sweep.tool->parts) {
    if (sweep.tip.low.z + part.whole.lowest() < stock_top) {
      reach = std::max(reach, part.whole.reach());
    }
  }
  return reach;
}

}  // namespace

TileWork::TileWork(Columns& columns, unsigned jobs)
    : columns_(columns), jobs_(std::max(1U, jobs)), of_tile_(columns.grid().tiles()) {}

void TileWork::run(std::span<const ReadySweep> sweeps, std::span<Outcome> outcomes) {
  sweeps_ = sweeps;
  outcomes_ = outcomes;
  columns_met_ = 0;
  for (std::size_t i = 0; i < sweeps.size(); ++i) list(static_cast<std::uint32_t>(i));
  share();
  for (const std::size_t tile : busy_) of_tile_[tile].clear();
  busy_.clear();
}

void TileWork::list(std::uint32_t number) {
  const ReadySweep& sweep = sweeps_[number];
  const Grid& grid = columns_.grid();
  const Bounds& box = grid.box;
  if (sweep.tip.low.z >= box.high.z) return;
  const double reach = reach_of(sweep, box.high.z);
  const int i0 =
      std::max(0, tile_of(sweep.tip.low.x - reach, box.low.x, grid.cell_x(), grid.tiles_x()));
  const int j0 =
      std::max(0, tile_of(sweep.tip.low.y - reach, box.low.y, grid.cell_y(), grid.tiles_y()));
  const int i1 = tile_of(sweep.tip.high.x + reach, box.low.x, grid.cell_x(), grid.tiles_x());
  const int j1 = tile_of(sweep.tip.high.y + reach, box.low.y, grid.cell_y(), grid.tiles_y());
  for (int j = j0; j <= std::min(j1, grid.tiles_y() - 1); ++j) {
    for (int i = i0; i <= std::min(i1, grid.tiles_x() - 1); ++i) {
      list_at(static_cast<std::size_t>(j * grid.tiles_x() + i), number);
    }
  }
  columns_met_ += (sweep.tip.high.x - sweep.tip.low.x + 2 * reach) *
                  (sweep.tip.high.y - sweep.tip.low.y + 2 * reach) /
                  (grid.cell_x() * grid.cell_y());
}

void TileWork::list_at(std::size_t tile, std::uint32_t number) {
  if (of_tile_[tile].empty()) busy_.push_back(tile);
  of_tile_[tile].push_back(number);
}

void TileWork::share() {
  base::each_by_threads(
      busy_.size(), columns_met_ < kWorthThreads ? 1 : jobs_,
      [&](std::size_t i) { work_on(busy_[i]); }, helper_);
}

void TileWork::work_on(std::size_t tile) {
  const Grid& grid = columns_.grid();
  TileCutter cutter(columns_, tile);
  Tally tally;
  for (const std::uint32_t number : of_tile_[tile]) {
    const ReadySweep& sweep = sweeps_[number];
    tally.begin(*sweep.tool);
    cutter.cut(sweep, tally);
    if (tally.is_empty()) continue;
    const std::scoped_lock lock(locks_[number % locks_.size()]);
    tally.take_to(outcomes_[number], grid.cell_x() * grid.cell_y());
  }
}

}  // namespace kerf::stock::field
