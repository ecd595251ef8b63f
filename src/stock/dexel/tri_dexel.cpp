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
#include "stock/dexel/tile_work.hpp"

namespace kerf::stock::dexel {
namespace {

constexpr std::size_t kSweepsAtOnce = 4096;
constexpr double kFixed_mm = 0.001;  // stock.md §4
constexpr double kFixedOfCell = 0.01;
constexpr double kTurningOfCell = 0.02;
constexpr double kContact_mm = 1e-6;

double cells(double length, double cell) { return std::max(1.0, std::ceil(length / cell - 1e-9)); }

int main_axis(Vec3 up) {
  const double x = std::fabs(up.x);
  const double y = std::fabs(up.y);
  const double z = std::fabs(up.z);
  if (z >= x && z >= y) return 2;
  return x >= y ? 0 : 1;
}

/// Largest distance of a corner of the box around the middle from a place.
double farthest(Vec3 half, Vec3 place) {
  return math::hypot(std::fabs(place.x) + half.x, std::fabs(place.y) + half.y,
                     std::fabs(place.z) + half.z);
}

/// What is above the stock needs no turning.
void cut_off(std::vector<PosedSolid>& solids, double height) {
  const auto is_above = [&](const PosedSolid& each) { return each.solid.low >= height; };
  solids.erase(std::remove_if(solids.begin(), solids.end(), is_above), solids.end());
  for (PosedSolid& each : solids) each.solid.high = std::min(each.solid.high, height);
}

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

}  // namespace

bool TriDexel::Trail::goes_on(const Sweep& sweep) const {
  const bool is_fixed = !std::holds_alternative<TurningWay>(sweep.way);
  return is_cut && is_fixed && sweep.body == body && sweep.axis == axis &&
         point_at(sweep.way, 0) == tip;
}

TriDexel::Trail TriDexel::Trail::after(const Sweep& sweep, bool cuts) {
  const bool is_fixed = !std::holds_alternative<TurningWay>(sweep.way);
  return {cuts && is_fixed && sweep.kind == SweepKind::cut, sweep.body, sweep.axis,
          point_at(sweep.way, 1)};
}

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

/// Sweeps made ready, and which tiles each of them may touch.
struct TriDexel::Call {
  struct Touched {
    std::size_t grid;
    std::size_t tile;
    std::vector<std::uint32_t> tasks;
  };

  std::vector<Stroke> strokes;
  std::deque<PosedTool> posed;
  std::vector<Task> tasks;
  std::array<std::vector<std::uint32_t>, 3> place;  ///< of a tile in touched, + 1
  std::vector<Touched> touched;

  void touch(std::size_t grid, std::size_t tile, std::uint32_t task) {
    std::uint32_t& at = place[grid][tile];
    if (at == 0) {
      touched.push_back({grid, tile, {}});
      at = static_cast<std::uint32_t>(touched.size());
    }
    touched[at - 1].tasks.push_back(task);
  }
};

TriDexel::TriDexel(const Shape& shape, double cell_mm, unsigned jobs)
    : box_(shape.box),
      middle_(0.5 * (shape.box.low + shape.box.high)),
      volume_(shape.volume_mm3),
      threads_(std::make_unique<Threads>(jobs)) {
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
  threads_->each(grid.tiles.size(), [&](std::size_t t) {
    const int column = grid.first_column(t);
    const int row = grid.first_row(t);
    Tile tile(std::min(Lattice::kTile, lattice.columns - column),
              std::min(Lattice::kTile, lattice.rows - row), lattice.half_s);
    std::vector<Interval> intervals;
    for (std::size_t i = 0; i < tile.count(); ++i) {
      const double b = b0 + lattice.b_of(column + static_cast<int>(i) % tile.columns());
      const double c = c0 + lattice.c_of(row + static_cast<int>(i) / tile.columns());
      intervals.clear();
      shape.inside(axis, b, c, intervals);
      tile.fill(i, ends_of(intervals, on_axis(middle_, axis)));
    }
    tile.refresh();
    grid.tiles[t] = std::move(tile);
  });
}

BodyId TriDexel::add_body(const Body& body) {
  const double tolerance = std::min(kFixed_mm, kFixedOfCell * cell_) / 2;
  tools_.push_back(Tool::of(body, tolerance));
  return static_cast<BodyId>(tools_.size() - 1);
}

bool TriDexel::can_cut(const Sweep& sweep) const {
  return sweep.body < tools_.size() && !tools_[sweep.body].solids.empty();
}

void TriDexel::cut(std::span<const Sweep> sweeps, std::span<Outcome> outcomes) {
  assert(sweeps.size() == outcomes.size());
  for (std::size_t i = 0; i < sweeps.size(); i += kSweepsAtOnce) {
    const std::size_t count = std::min(kSweepsAtOnce, sweeps.size() - i);
    cut_some(sweeps.subspan(i, count), outcomes.subspan(i, count));
  }
}

namespace {

/// Makes tasks of sweeps.
class Preparation {
 public:
  Preparation(const std::deque<Tool>& tools, Vec3 middle, Vec3 half, double cell, double block)
      : tools_(tools), middle_(middle), half_(half), cell_(cell), block_(block) {}

  void strokes(const Sweep& sweep, std::vector<Stroke>& out) const {
    append_strokes(sweep.way, middle_, std::min(kFixed_mm, kFixedOfCell * cell_) / 2, out);
  }
  [[nodiscard]] Task task(const Sweep& sweep, std::size_t number, std::span<const Stroke> strokes,
                          std::deque<PosedTool>& posed) {
    const Tool& tool = tools_[sweep.body];
    const auto* turning = std::get_if<TurningWay>(&sweep.way);
    const bool is_same = turning == nullptr && !posed.empty() && !last_turned_ &&
                         posed.back().tool == &tool && posed.back().frame.up == sweep.axis;
    if (!is_same) posed.push_back(PosedTool::of(tool, sweep.axis, block_));
    last_turned_ = turning != nullptr;
    if (turning != nullptr) limit(posed.back(), *turning);
    return {&sweep, &posed.back(),         strokes,
            number, main_axis(sweep.axis), std::max(kFixed_mm, kTurningOfCell * cell_)};
  }
  /// From the middle of the stock.
  [[nodiscard]] Bounds box(const Task& task) const {
    const Bounds tips = bounds(task.sweep->way);
    const Bounds& reach = task.posed->reach;
    return {tips.low - middle_ + reach.low, tips.high - middle_ + reach.high};
  }

 private:
  void limit(PosedTool& posed, const TurningWay& way) const {
    const double height =
        std::max(farthest(half_, way.from - middle_), farthest(half_, way.to - middle_));
    cut_off(posed.solids, height);
    cut_off(posed.touching, height);
    const double all = math::hypot(std::min(height, posed.tool->height), posed.tool->widest);
    posed.reach = {{-all, -all, -all}, {all, all, all}};
  }

  const std::deque<Tool>& tools_;
  Vec3 middle_;
  Vec3 half_;
  double cell_;
  double block_;
  bool last_turned_ = false;
};

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

void TriDexel::cut_some(std::span<const Sweep> sweeps, std::span<Outcome> outcomes) {
  Call call;
  Preparation prepare(tools_, middle_, half(), cell_, block_);
  std::vector<std::size_t> begin{0};
  for (const Sweep& sweep : sweeps) {
    prepare.strokes(sweep, call.strokes);
    begin.push_back(call.strokes.size());
  }
  for (std::size_t g = 0; g < 3; ++g) call.place[g].assign(grids_[g]->tiles.size(), 0);
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const std::span<const Stroke> strokes(call.strokes.data() + begin[i], begin[i + 1] - begin[i]);
    call.tasks.push_back(prepare.task(sweeps[i], i, strokes, call.posed));
    call.tasks.back().follows = trail_.goes_on(sweeps[i]);
    trail_ = Trail::after(sweeps[i], tools_[sweeps[i].body].body.cuts);
    const Bounds box = prepare.box(call.tasks.back());
    for (std::size_t g = 0; g < 3; ++g) {
      grids_[g]->each_in(
          box, [&](std::size_t tile) { call.touch(g, tile, static_cast<std::uint32_t>(i)); });
    }
  }
  tbb::enumerable_thread_specific<Tally> tallies([&] {
    return Tally{std::vector<Outcome>(sweeps.size()), {}};
  });
  threads_->each(call.touched.size(), [&](std::size_t t) {
    const Call::Touched& touched = call.touched[t];
    Grid& grid = *grids_[touched.grid];
    TileWork work(grid.lattice, grid.tiles[touched.tile], grid.first_column(touched.tile),
                  grid.first_row(touched.tile), middle_);
    Tally& tally = tallies.local();
    for (const std::uint32_t task : touched.tasks) work.cut(call.tasks[task], tally);
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

std::size_t TriDexel::bytes() const {
  std::size_t sum = sizeof(*this);
  for (const auto& grid : grids_) {
    for (const Tile& tile : grid->tiles) sum += tile.bytes();
  }
  return sum;
}

std::optional<double> TriDexel::first_contact(const Sweep& sweep) const {
  const auto* way = std::get_if<StraightWay>(&sweep.way);
  assert(way != nullptr);
  const PosedTool posed = PosedTool::of(tools_[sweep.body], sweep.axis, block_);
  const Stroke whole{way->from - middle_, way->to - way->from};
  const auto meets = [&](double t) {
    const Stroke stroke{whole.from, t * whole.way};
    const Bounds box = swept(posed.reach, stroke.from, stroke.way);
    bool met = false;
    for (const auto& grid : grids_) {
      grid->each_in(box, [&](std::size_t t_number) {
        if (met) return;
        TileWork work(grid->lattice, grid->tiles[t_number], grid->first_column(t_number),
                      grid->first_row(t_number), middle_);
        met = work.meets(posed, stroke);
      });
    }
    return met;
  };
  if (!meets(1)) return std::nullopt;
  if (meets(0)) return 0.0;
  double clear = 0;
  double met = 1;
  const double enough = kContact_mm / std::max(kContact_mm, length(*way));
  while (met - clear > enough) {
    const double middle = (clear + met) / 2;
    (meets(middle) ? met : clear) = middle;
  }
  return clear;
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
  trail_ = {};
  to.refresh();
  to.mark_changed();
  return true;
}

}  // namespace kerf::stock::dexel
