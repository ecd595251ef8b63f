#include "stock/dexel/tri_dexel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "math/math.hpp"
#include "stock/dexel/ball_contact.hpp"
#include "stock/dexel/pieces.hpp"
#include "stock/dexel/preparation.hpp"
#include "stock/dexel/tile_work.hpp"

namespace kerf::stock::dexel {
namespace {

constexpr std::size_t kSweepsAtOnce = 4096;
constexpr double kMostLooks = 1e6;  // of a probe thinner than a cell
constexpr int kHalvings = 40;

double cells(double length, double cell) { return std::max(1.0, std::ceil(length / cell - 1e-9)); }

DexelEnd stock_end(double at, double middle, Vec3 normal) {
  return {static_cast<float>(at - middle), octahedral(normal), 0, 0};
}

std::vector<DexelEnd> ends_of(const std::vector<Interval>& intervals, double middle) {
  std::vector<DexelEnd> ends;
  for (const Interval& each : intervals) {
    if (each.high - each.low < Tile::kLeast_mm) continue;
    ends.push_back(stock_end(each.low, middle, each.low_normal));
    ends.push_back(stock_end(each.high, middle, each.high_normal));
  }
  return ends;
}

double length_of(std::span<const DexelEnd> ends) {
  double length = 0;
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    length += double{ends[i + 1].at} - double{ends[i].at};
  }
  return length;
}

bool is_sound(std::span<const DexelEnd> ends, double half) {
  double last = -half * (1 + 1e-6);
  for (const DexelEnd& end : ends) {
    if (!(double{end.at} >= last)) return false;
    last = double{end.at};
  }
  return last <= half * (1 + 1e-6);
}

/// Of the contacts of one sweep and part those that stand: of the first rank that has any.
void settle(std::vector<AsideContact>& aside, std::span<Outcome> outcomes) {
  for (const int rank : {1, 2}) {
    std::vector<AsideContact> open;
    for (const AsideContact& each : aside) {
      if (!outcomes[each.number].contacts[each.part].is_one()) open.push_back(each);
    }
    for (const AsideContact& each : open) {
      if (each.rank == rank) outcomes[each.number].contacts[each.part].add(each.contact);
    }
    aside = std::move(open);
  }
}

}  // namespace

struct TriDexel::Threads {
  explicit Threads(unsigned jobs)
      : arena(jobs == 0 ? tbb::info::default_concurrency()
                        : std::min(static_cast<int>(std::min(jobs, 4096U)),
                                   tbb::info::default_concurrency())) {}

  /// work(i) for i below count, each once, in any order.
  template <class Work>
  void each(std::size_t count, Work&& work) {
    arena.execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, count, 1),
          [&](const auto& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) work(i);
          },
          tbb::simple_partitioner());
    });
  }

  tbb::task_arena arena;
};

struct TriDexel::Grid {
  Lattice lattice;
  std::vector<Tile> tiles;

  [[nodiscard]] int first_column(std::size_t tile) const {
    return static_cast<int>(tile) % lattice.tiles_b() * Lattice::kTile;
  }
  [[nodiscard]] int first_row(std::size_t tile) const {
    return static_cast<int>(tile) / lattice.tiles_b() * Lattice::kTile;
  }
  [[nodiscard]] TileWork work(std::size_t tile, Vec3 middle) {
    return {lattice, tiles[tile], first_column(tile), first_row(tile), middle};
  }
  /// Whether the dexel of the cell that a place lies in has material there.
  [[nodiscard]] bool holds(Vec3 place) const {
    const double b =
        on_axis(place, (lattice.axis + 1) % 3) / lattice.cell_b + lattice.columns / 2.0;
    const double c = on_axis(place, (lattice.axis + 2) % 3) / lattice.cell_c + lattice.rows / 2.0;
    if (!(b >= 0 && b < lattice.columns && c >= 0 && c < lattice.rows)) return false;
    const int column = static_cast<int>(b);
    const int row = static_cast<int>(c);
    const Tile& tile = tiles[static_cast<std::size_t>(row / Lattice::kTile * lattice.tiles_b() +
                                                      column / Lattice::kTile)];
    return tile.holds(tile.index(column % Lattice::kTile, row % Lattice::kTile),
                      static_cast<float>(on_axis(place, lattice.axis)));
  }
  /// act(tile) for each that has dexels in the box, which is from the middle of the stock.
  template <class Act>
  void each_in(const Bounds& box, Act&& act) const {
    const int b = (lattice.axis + 1) % 3;
    const int c = (lattice.axis + 2) % 3;
    const int a = lattice.axis;
    if (on_axis(box.low, a) > lattice.half_s || on_axis(box.high, a) < -lattice.half_s) return;
    const CellRange columns = lattice.columns_in(on_axis(box.low, b), on_axis(box.high, b));
    const CellRange rows = lattice.rows_in(on_axis(box.low, c), on_axis(box.high, c));
    if (columns.first > columns.last || rows.first > rows.last) return;
    for (int row = rows.first / Lattice::kTile; row <= rows.last / Lattice::kTile; ++row) {
      const int last = columns.last / Lattice::kTile;
      for (int column = columns.first / Lattice::kTile; column <= last; ++column) {
        act(static_cast<std::size_t>(row * lattice.tiles_b() + column));
      }
    }
  }
};

/// Which tasks touch which tile, in order.
struct TriDexel::Touched {
  std::size_t grid;
  std::size_t tile;
  std::vector<std::uint32_t> tasks;
};

TriDexel::TriDexel(const Shape& shape, double cell_mm, unsigned jobs)
    : box_(shape.box),
      middle_(0.5 * (shape.box.low + shape.box.high)),
      volume_(shape.volume_mm3),
      threads_(std::make_unique<Threads>(jobs)),
      trail_(std::make_unique<Trail>()) {
  for (int axis = 0; axis < 3; ++axis) make_grid(axis, shape, cell_mm);
  whole_ = grids_mm3();
  if (volume_ == 0) volume_ = whole_[2];
}

TriDexel::~TriDexel() = default;

double TriDexel::bytes_for(const Bounds& box, double cell_mm) {
  const double x = cells(box.high.x - box.low.x, cell_mm);
  const double y = cells(box.high.y - box.low.y, cell_mm);
  const double z = cells(box.high.z - box.low.z, cell_mm);
  return (x * y + y * z + z * x) * (8 + 2 * sizeof(DexelEnd));
}

Vec3 TriDexel::half() const { return 0.5 * (box_.high - box_.low); }

void TriDexel::make_grid(int axis, const Shape& shape, double cell_mm) {
  auto grid = std::make_unique<Grid>();
  const Vec3 size = box_.high - box_.low;
  const double size_b = on_axis(size, (axis + 1) % 3);
  const double size_c = on_axis(size, (axis + 2) % 3);
  const double columns = cells(size_b, cell_mm);
  const double rows = cells(size_c, cell_mm);
  grid->lattice = {
      axis,          static_cast<int>(columns), static_cast<int>(rows), size_b / columns,
      size_c / rows, on_axis(size, axis) / 2};
  const Lattice& lattice = grid->lattice;
  cell_ = std::max({cell_, lattice.cell_b, lattice.cell_c});
  // A little more, for rounding.
  block_ =
      std::max(block_, 0.501 * (Tile::kBlock - 1) * math::hypot(lattice.cell_b, lattice.cell_c));
  grid->tiles.resize(static_cast<std::size_t>(lattice.tiles_b()) *
                     static_cast<std::size_t>(lattice.tiles_c()));
  fill(*grid, shape);
  grids_[static_cast<std::size_t>(axis)] = std::move(grid);
}

void TriDexel::fill(Grid& grid, const Shape& shape) {
  const Lattice& lattice = grid.lattice;
  const int axis = lattice.axis;
  const double b0 = on_axis(middle_, (axis + 1) % 3);
  const double c0 = on_axis(middle_, (axis + 2) % 3);
  const InsideOf inside = shape.on_lattice ? shape.on_lattice(lattice, middle_)
                                           : [&](int column, int row, std::vector<Interval>& out) {
                                               shape.inside(axis, b0 + lattice.b_of(column),
                                                            c0 + lattice.c_of(row), out);
                                             };
  threads_->each(grid.tiles.size(), [&](std::size_t t) {
    const int column = grid.first_column(t);
    const int row = grid.first_row(t);
    Tile tile(std::min(Lattice::kTile, lattice.columns - column),
              std::min(Lattice::kTile, lattice.rows - row), lattice.half_s);
    std::vector<Interval> intervals;
    for (std::size_t i = 0; i < tile.count(); ++i) {
      intervals.clear();
      inside(column + static_cast<int>(i) % tile.columns(),
             row + static_cast<int>(i) / tile.columns(), intervals);
      tile.fill(i, ends_of(intervals, on_axis(middle_, axis)));
    }
    tile.refresh();
    grid.tiles[t] = std::move(tile);
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
  tbb::enumerable_thread_specific<Tally> tallies([&] {
    return Tally{std::vector<Outcome>(sweeps.size()), {}};
  });
  threads_->each(touched.size(), [&](std::size_t i) {
    Grid& grid = *grids_[touched[i].grid];
    TileWork work = grid.work(touched[i].tile, middle_);
    Tally& tally = tallies.local();
    for (const std::uint32_t task : touched[i].tasks) work.cut(ready.tasks()[task], tally);
  });
  std::vector<Outcome> sums(sweeps.size());
  std::vector<AsideContact> aside;
  for (const Tally& tally : tallies) {
    for (std::size_t i = 0; i < sweeps.size(); ++i) sums[i].add(tally.outcomes[i]);
    aside.insert(aside.end(), tally.aside.begin(), tally.aside.end());
  }
  settle(aside, sums);
  for (std::size_t i = 0; i < sweeps.size(); ++i) outcomes[i].add(sums[i]);
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
  std::array<double, 3> sums{};
  for (std::size_t g = 0; g < 3; ++g) {
    for (const Tile& tile : grids_[g]->tiles) {
      double length = 0;
      for (std::size_t i = 0; i < tile.count(); ++i) length += length_of(tile.ends(i));
      sums[g] += length * grids_[g]->lattice.cell_area();
    }
  }
  return sums;
}

/// P of stock.md §3, Volumes: cut face alongside the dexels of each grid, mm².
std::array<double, 3> TriDexel::alongside() const {
  std::array<double, 3> sums{};
  for (const auto& grid : grids_) {
    const int axis = grid->lattice.axis;
    for (const Tile& tile : grid->tiles) {
      for (std::size_t i = 0; i < tile.count(); ++i) {
        for (const DexelEnd& end : tile.ends(i)) {
          if (end.motion == 0) continue;
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

std::size_t TriDexel::best_grid() const {
  const std::array<double, 3> faces = alongside();
  if (faces[2] <= faces[0] && faces[2] <= faces[1]) return 2;
  return faces[0] <= faces[1] ? 0 : 1;
}

double TriDexel::left_mm3() const {
  const std::size_t grid = best_grid();
  return volume_ - (whole_[grid] - grids_mm3()[grid]);
}

double TriDexel::stock_mm3() const { return volume_; }
Trail TriDexel::trail() const { return *trail_; }
void TriDexel::restore_trail(const Trail& trail) { *trail_ = trail; }
double TriDexel::error_mm3() const { return 0.5 * cell_ * alongside()[best_grid()]; }

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

const Lattice& TriDexel::lattice(int grid) const {
  return grids_[static_cast<std::size_t>(grid)]->lattice;
}

std::size_t TriDexel::tiles(int grid) const {
  return grids_[static_cast<std::size_t>(grid)]->tiles.size();
}

const Tile& TriDexel::tile(int grid, std::size_t number) const {
  return grids_[static_cast<std::size_t>(grid)]->tiles[number];
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

}  // namespace kerf::stock::dexel
