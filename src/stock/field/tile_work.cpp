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

void add(Bounds& to, const Bounds& other) {
  to.low.x = std::min(to.low.x, other.low.x);
  to.low.y = std::min(to.low.y, other.low.y);
  to.high.x = std::max(to.high.x, other.high.x);
  to.high.y = std::max(to.high.y, other.high.y);
}

/// Where a tool may do something: beyond what its edges lower only where a part that may not meet
/// material comes down to the stock.
Bounds reached_by(const ReadySweep& sweep, double stock_top) {
  Bounds all = sweep.reached;
  for (std::size_t i = 0; i < kToolParts; ++i) {
    const LowerEnvelope& body = sweep.tool->parts[i].whole;
    if (!sweep.guards(static_cast<ToolPart>(i)) || body.is_empty()) continue;
    if (sweep.tip.low.z + body.lowest() < stock_top) add(all, around(sweep.tip, body.reach()));
  }
  return all;
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
  const Bounds reached = reached_by(sweep, box.high.z);
  const int i0 = std::max(0, tile_of(reached.low.x, box.low.x, grid.cell_x(), grid.tiles_x()));
  const int j0 = std::max(0, tile_of(reached.low.y, box.low.y, grid.cell_y(), grid.tiles_y()));
  const int i1 = tile_of(reached.high.x, box.low.x, grid.cell_x(), grid.tiles_x());
  const int j1 = tile_of(reached.high.y, box.low.y, grid.cell_y(), grid.tiles_y());
  for (int j = j0; j <= std::min(j1, grid.tiles_y() - 1); ++j) {
    for (int i = i0; i <= std::min(i1, grid.tiles_x() - 1); ++i) {
      list_at(static_cast<std::size_t>(j * grid.tiles_x() + i), number);
    }
  }
  columns_met_ += (reached.high.x - reached.low.x) * (reached.high.y - reached.low.y) /
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
