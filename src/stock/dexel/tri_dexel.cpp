#include "stock/dexel/tri_dexel.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/each_by_threads.hpp"
#include "math/math.hpp"
#include "stock/dexel/ball_contact.hpp"
#include "stock/dexel/dexel_ends.hpp"
#include "stock/dexel/grid.hpp"
#include "stock/dexel/pieces.hpp"
#include "stock/dexel/preparation.hpp"
#include "stock/dexel/shape_work.hpp"
#include "stock/dexel/tally.hpp"
#include "stock/dexel/tile_work.hpp"

namespace kerf::stock::dexel {
namespace {

constexpr std::size_t kSweepsAtOnce = 16384;
// Of a probe thinner than a cell.
constexpr double kMostLooks = 1e6;
constexpr int kHalvings = 40;

bool any_motion(std::uint32_t) { return true; }

double cells_along(double length, double cell) {
  return std::max(1.0, std::ceil(length / cell - 1e-9));
}

TriDexel::CellCounts cells_of(const Bounds& box, double cell) {
  const Vec3 size = box.high - box.low;
  return {static_cast<int>(cells_along(size.x, cell)), static_cast<int>(cells_along(size.y, cell)),
          static_cast<int>(cells_along(size.z, cell))};
}

}  // namespace

struct TriDexel::Threads {
  explicit Threads(unsigned jobs) : count(base::useful_threads(jobs)), tallies(count) {}

  /// As base::each_by_threads().
  template <class Work>
  void each(std::size_t items, const Work& work) {
    base::each_by_threads(items, count, work, helper);
  }

  unsigned count;
  base::Helper* helper = nullptr;
  Tallies tallies;
};

/// Which tasks touch which tile, in order.
struct TriDexel::Touched {
  std::size_t grid;
  std::size_t tile;
  std::vector<std::uint32_t> tasks;
};

TriDexel::TriDexel(const Bounds& box, const CellCounts& cells, unsigned jobs)
    : box_(box),
      middle_(0.5 * (box.low + box.high)),
      threads_(std::make_unique<Threads>(jobs)),
      trail_(std::make_unique<Trail>()) {
  for (int axis = 0; axis < 3; ++axis) make_grid(axis, cells);
}

TriDexel::TriDexel(const Shape& shape, double cell_mm, unsigned jobs)
    : TriDexel(shape, cells_of(shape.box, cell_mm), jobs) {}

TriDexel::TriDexel(const Shape& shape, const CellCounts& cells, unsigned jobs)
    : TriDexel(shape.box, cells, jobs) {
  for (const auto& grid : grids_) fill(*grid, shape);
  whole_ = grids_mm3();
  volume_ = shape.volume_mm3 > 0 ? shape.volume_mm3 : whole_[2];
}

std::unique_ptr<TriDexel> TriDexel::of(const State& state, unsigned jobs) {
  std::unique_ptr<TriDexel> made(new TriDexel(state.box, state.cells, jobs));
  for (int g = 0; g < 3; ++g) {
    const auto& tiles = state.tiles[static_cast<std::size_t>(g)];
    if (tiles.size() != made->tiles(g)) return nullptr;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
      if (!made->restore(g, i, tiles[i])) return nullptr;
    }
  }
  made->whole_ = made->grids_mm3();
  made->volume_ = state.volume_mm3;
  return made;
}

TriDexel::~TriDexel() = default;

double TriDexel::bytes_for(const Bounds& box, double cell_mm) {
  const double x = cells_along(box.high.x - box.low.x, cell_mm);
  const double y = cells_along(box.high.y - box.low.y, cell_mm);
  const double z = cells_along(box.high.z - box.low.z, cell_mm);
  return (x * y + y * z + z * x) * (8 + 2 * sizeof(DexelEnd));
}

void TriDexel::use(base::Helper* helper) { threads_->helper = helper; }

Vec3 TriDexel::half() const { return 0.5 * (box_.high - box_.low); }

void TriDexel::make_grid(int axis, const CellCounts& cells) {
  auto grid = std::make_unique<Grid>();
  const Vec3 size = box_.high - box_.low;
  const int b = (axis + 1) % 3;
  const int c = (axis + 2) % 3;
  const int columns = cells[static_cast<std::size_t>(b)];
  const int rows = cells[static_cast<std::size_t>(c)];
  grid->lattice = {axis,
                   columns,
                   rows,
                   on_axis(size, b) / columns,
                   on_axis(size, c) / rows,
                   on_axis(size, axis) / 2};
  const Lattice& lattice = grid->lattice;
  cell_ = std::max({cell_, lattice.cell_b, lattice.cell_c});
  // A little more, for rounding.
  block_ =
      std::max(block_, 0.501 * (Tile::kBlock - 1) * math::hypot(lattice.cell_b, lattice.cell_c));
  grid->tiles.resize(static_cast<std::size_t>(lattice.tiles_b()) *
                     static_cast<std::size_t>(lattice.tiles_c()));
  for (std::size_t t = 0; t < grid->tiles.size(); ++t) {
    grid->tiles[t] =
        Tile(std::min(Lattice::kTile, lattice.columns - grid->first_column(t)),
             std::min(Lattice::kTile, lattice.rows - grid->first_row(t)), lattice.half_s);
  }
  grids_[static_cast<std::size_t>(axis)] = std::move(grid);
}

void TriDexel::fill(Grid& grid, const Shape& shape) {
  const Lattice& lattice = grid.lattice;
  const InsideOf inside = inside_of(shape, lattice, middle_);
  threads_->each(grid.tiles.size(), [&](std::size_t t) {
    const int column = grid.first_column(t);
    const int row = grid.first_row(t);
    Tile& tile = grid.tiles[t];
    std::vector<Interval> intervals;
    for (std::size_t i = 0; i < tile.count(); ++i) {
      intervals.clear();
      inside(column + static_cast<int>(i) % tile.columns(),
             row + static_cast<int>(i) / tile.columns(), intervals);
      tile.fill(i, ends_of(intervals, on_axis(middle_, lattice.axis)));
    }
    tile.refresh();
  });
}

BodyId TriDexel::add_body(const Body& body) {
  tools_.push_back(Tool::of(body, fixed_tolerance_mm(cell_) / 2));
  return static_cast<BodyId>(tools_.size() - 1);
}

bool TriDexel::can_cut(const Sweep& sweep) const {
  const double size = length(sweep.axis) + length(sweep.way) + length(point_at(sweep.way, 0)) +
                      length(point_at(sweep.way, 1));
  return std::isfinite(size) && sweep.body < tools_.size() && !tools_[sweep.body].solids.empty();
}

void TriDexel::cut(std::span<const Sweep> sweeps, std::span<Outcome> outcomes) {
  assert(sweeps.size() == outcomes.size());
  for (std::size_t i = 0; i < sweeps.size(); i += kSweepsAtOnce) {
    const std::size_t count = std::min(kSweepsAtOnce, sweeps.size() - i);
    cut_some(sweeps.subspan(i, count), outcomes.subspan(i, count));
  }
}

void TriDexel::cut_some(std::span<const Sweep> sweeps, std::span<Outcome> outcomes) {
  const Preparation ready(sweeps, tools_, {middle_, half(), cell_, block_}, *trail_);
  const std::vector<Touched> touched = this->touched(ready);
  threads_->each(touched.size(), [&](std::size_t i, std::size_t worker) {
    Grid& grid = *grids_[touched[i].grid];
    grid.work(touched[i].tile, middle_)
        .cut(ready.tasks(), touched[i].tasks, threads_->tallies.own(worker, sweeps.size()));
  });
  threads_->tallies.take(outcomes,
                         [&](std::size_t count, const auto& work) { threads_->each(count, work); });
}

std::vector<TriDexel::Touched> TriDexel::touched(const Preparation& ready) const {
  std::vector<Touched> all;
  for (std::size_t g = 0; g < 3; ++g) {
    std::vector<std::size_t> place(grids_[g]->tiles.size(), 0);  // in all, + 1
    for (const Task& task : ready.tasks()) {
      grids_[g]->each_in(ready.box(task), [&](std::size_t tile) {
        if (place[tile] == 0) {
          all.push_back({g, tile, {}});
          place[tile] = all.size();
        }
        all[place[tile] - 1].tasks.push_back(static_cast<std::uint32_t>(task.number));
      });
    }
  }
  return all;
}

std::array<double, 3> TriDexel::grids_mm3() const {
  return {grids_[0]->volume(), grids_[1]->volume(), grids_[2]->volume()};
}

std::array<double, 3> TriDexel::alongside(const CountsMotion& counts) const {
  std::array<double, 3> sums{};
  for (const auto& grid : grids_) {
    const int axis = grid->lattice.axis;
    for (const Tile& tile : grid->tiles) {
      for (std::size_t i = 0; i < tile.count(); ++i) {
        for (const DexelEnd& end : tile.ends(i)) {
          if (end.motion == 0 || !counts(end.motion)) continue;
          const Vec3 n = direction(end.normal);
          const double area = grid->lattice.cell_area() * std::fabs(on_axis(n, axis));
          sums[0] += area * (1 - std::fabs(n.x));
          sums[1] += area * (1 - std::fabs(n.y));
          sums[2] += area * (1 - std::fabs(n.z));
        }
      }
    }
  }
  return sums;
}

std::size_t TriDexel::best_of(const std::array<double, 3>& faces) {
  if (faces[2] <= faces[0] && faces[2] <= faces[1]) return 2;
  return faces[0] <= faces[1] ? 0 : 1;
}

std::size_t TriDexel::best_grid() const { return best_of(alongside(any_motion)); }

double TriDexel::left_mm3() const {
  const std::size_t grid = best_grid();
  return volume_ - (whole_[grid] - grids_mm3()[grid]);
}

double TriDexel::stock_mm3() const { return volume_; }

double TriDexel::error_mm3() const {
  const std::array<double, 3> faces = alongside(any_motion);
  return 0.5 * cell_ * faces[best_of(faces)];
}

Bounds TriDexel::extents() const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{kFar, kFar, kFar};
  std::array<double, 3> high{-kFar, -kFar, -kFar};
  for (std::size_t g = 0; g < 3; ++g) {
    for (const Tile& tile : grids_[g]->tiles) {
      for (std::size_t i = 0; i < tile.count(); ++i) {
        const auto ends = tile.ends(i);
        if (ends.empty()) continue;
        low[g] = std::min(low[g], double{ends.front().at});
        high[g] = std::max(high[g], double{ends.back().at});
      }
    }
  }
  return {middle_ + Vec3{low[0], low[1], low[2]}, middle_ + Vec3{high[0], high[1], high[2]}};
}

std::vector<Piece> TriDexel::pieces() const {
  std::vector<Piece> all = pieces_of(*this, static_cast<int>(best_grid()), box_.low.z);
  if (all.size() == 1) all.front().volume_mm3 = left_mm3();
  return all;
}

std::size_t TriDexel::bytes() const {
  std::size_t sum = sizeof(*this);
  for (const auto& grid : grids_) {
    for (const Tile& tile : grid->tiles) sum += tile.bytes();
  }
  return sum;
}

/// All three grids have material there, the place from the middle of the stock.
bool TriDexel::holds(Vec3 place) const {
  return std::all_of(grids_.begin(), grids_.end(),
                     [&](const auto& grid) { return grid->holds(place); });
}

/// Deeper in the material than a ball that has left it.
bool TriDexel::is_deep(Vec3 place) const {
  for (const double d : {-kLeft_mm, kLeft_mm}) {
    if (!holds(place + Vec3{d, 0, 0}) || !holds(place + Vec3{0, d, 0})) return false;
    if (!holds(place + Vec3{0, 0, d})) return false;
  }
  return true;
}

// Where faces of cells do not quite join, a point may slip in.
std::optional<double> TriDexel::first_between(const StraightWay& way) const {
  const double steps = std::clamp(std::ceil(2 * length(way) / cell_), 1.0, kMostLooks);
  for (double i = 1; i <= steps; ++i) {
    if (!is_deep(point_at(way, i / steps))) continue;
    double free = (i - 1) / steps;
    double met = i / steps;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (free + met) / 2;
      (is_deep(point_at(way, middle)) ? met : free) = middle;
    }
    return met;
  }
  return std::nullopt;
}

std::optional<double> TriDexel::first_touch(const BallWay& ball) const {
  const BallWay own{{ball.way.from - middle_, ball.way.to - middle_}, ball.radius_mm};
  if (is_deep(own.way.from)) return 0.0;
  BallContact contact(own);
  const Vec3 cell{cell_, cell_, cell_};
  const Bounds way = bounds(own);
  for (const auto& grid : grids_) {
    grid->each_in({way.low - cell, way.high + cell}, [&](std::size_t tile) {
      contact.look_at(grid->lattice, grid->tiles[tile], grid->first_column(tile),
                      grid->first_row(tile));
    });
  }
  if (ball.radius_mm >= cell_) return contact.first();
  const double limit = contact.first().value_or(1);
  const auto between = first_between(part(own.way, 0, limit));
  return between ? limit * *between : contact.first();
}

Stretch TriDexel::material_on(const StraightWay& line) const {
  constexpr double kAside_mm = 1e-9;
  const StraightWay own{line.from - middle_, line.to - middle_};
  const Vec3 way = line.to - line.from;
  for (const auto& grid : grids_) {
    const int a = grid->lattice.axis;
    const bool is_along = std::fabs(on_axis(way, (a + 1) % 3)) <= kAside_mm &&
                          std::fabs(on_axis(way, (a + 2) % 3)) <= kAside_mm;
    if (is_along) return grid->material_on(own);
  }
  Stretch all;
  const double steps = std::clamp(std::ceil(4 * length(way) / cell_), 1.0, kMostLooks);
  for (double i = 0; i <= steps; ++i) {
    if (holds(point_at(own, i / steps))) all.add(i / steps);
  }
  return all;
}

const Lattice& TriDexel::lattice(int grid) const {
  return grids_[static_cast<std::size_t>(grid)]->lattice;
}

std::size_t TriDexel::tiles(int grid) const {
  return grids_[static_cast<std::size_t>(grid)]->tiles.size();
}

const Tile& TriDexel::tile(int grid, std::size_t number) const {
  return grids_[static_cast<std::size_t>(grid)]->tiles[number];
}

// Sums of tiles are added in their order, whichever thread had made them.
template <class Look>
TriDexel::Common TriDexel::each_common(const Shape& shape, Look&& look) const {
  const Bounds box{shape.box.low - middle_, shape.box.high - middle_};
  Common sum;
  for (std::size_t g = 0; g < 3; ++g) {
    const Grid& grid = *grids_[g];
    const InsideOf inside = inside_of(shape, grid.lattice, middle_);
    std::vector<std::size_t> met;
    grid.each_in(box, [&](std::size_t tile) { met.push_back(tile); });
    std::vector<CommonLengths> lengths(met.size());
    threads_->each(met.size(), [&](std::size_t i) {
      const ShapeWork work(grid.lattice, box, grid.first_column(met[i]), grid.first_row(met[i]));
      lengths[i] = look(work, g, met[i], inside);
    });
    for (const CommonLengths& one : lengths) {
      sum.shape_mm3[g] += one.shape_mm * grid.lattice.cell_area();
      sum.part_mm3[g] += one.part_mm * grid.lattice.cell_area();
      sum.longest_mm = std::max(sum.longest_mm, one.longest_mm);
    }
  }
  return sum;
}

TriDexel::Common TriDexel::common(const Shape& shape) const {
  return each_common(shape, [&](const ShapeWork& work, std::size_t grid, std::size_t tile,
                                const InsideOf& inside) {
    return work.measure(grids_[grid]->tiles[tile], inside, middle_);
  });
}

TriDexel::Common TriDexel::subtract(const Shape& shape) {
  return each_common(shape, [&](const ShapeWork& work, std::size_t grid, std::size_t tile,
                                const InsideOf& inside) {
    return work.take(grids_[grid]->tiles[tile], inside, middle_);
  });
}

TriDexel::CellCounts TriDexel::cells() const {
  return {lattice(1).rows, lattice(0).columns, lattice(0).rows};
}

TriDexel::TileState TriDexel::save(int grid, std::size_t number) const {
  const Tile& from = tile(grid, number);
  TileState state;
  for (std::size_t i = 0; i < from.count(); ++i) {
    const auto ends = from.ends(i);
    state.counts.push_back(static_cast<std::uint16_t>(ends.size()));
    state.ends.insert(state.ends.end(), ends.begin(), ends.end());
  }
  return state;
}

bool TriDexel::restore(int grid, std::size_t number, const TileState& state) {
  Tile& to = grids_[static_cast<std::size_t>(grid)]->tiles[number];
  if (state.counts.size() != to.count()) return false;
  std::size_t sum = 0;
  for (const std::uint16_t count : state.counts) {
    if (count % 2 != 0 || count > Tile::kMostEnds || sum + count > state.ends.size()) return false;
    if (!is_sound(std::span(state.ends).subspan(sum, count), lattice(grid).half_s)) return false;
    sum += count;
  }
  if (sum != state.ends.size()) return false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < to.count(); ++i) {
    to.fill(i, std::span(state.ends).subspan(begin, state.counts[i]));
    begin += state.counts[i];
  }
  *trail_ = {};
  to.refresh();
  to.mark_changed();
  return true;
}

Trail TriDexel::trail() const { return *trail_; }
void TriDexel::restore_trail(const Trail& trail) { *trail_ = trail; }

}  // namespace kerf::stock::dexel
