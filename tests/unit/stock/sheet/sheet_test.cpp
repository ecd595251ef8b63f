// Coverage and energy of a sheet against closed formulas and brute force.
#include "stock/sheet/sheet.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "stock/sheet/pieces.hpp"

namespace kerf::stock::sheet {
namespace {

using std::numbers::pi;

constexpr double kKerf = 0.2;

Box square(double from, double to) { return {{from, from}, {to, to}}; }

Sheet sheet_of(const Box& box, double cell, double kerf = kKerf, unsigned jobs = 1) {
  return Sheet(grid_of(box, cell), {.kerf_mm = kerf, .jobs = jobs});
}

std::vector<Trace> outline(double from, double to) {
  const Vec2 a{from, from};
  const Vec2 b{to, from};
  const Vec2 c{to, to};
  const Vec2 d{from, to};
  return {straight(a, b), straight(b, c), straight(c, d), straight(d, a)};
}

/// stock.md §4.7, written out for one cell.
int covered(double distance, double kerf, double h) {
  const double share = std::clamp(0.5 + (kerf / 2 - distance) / h, 0.0, 1.0);
  return static_cast<int>(std::floor(share * 255 + 0.5));
}

/// The cell at i, j of the grid; 0 in an untouched tile.
int coverage_at(const Sheet& sheet, int i, int j) {
  const std::size_t tile = static_cast<std::size_t>(j / kTileSide * sheet.grid().tiles_x()) +
                           static_cast<std::size_t>(i / kTileSide);
  const Sheet::Coverage* const cells = sheet.coverage(tile);
  return cells == nullptr
             ? 0
             : (*cells)[static_cast<std::size_t>(j % kTileSide * kTileSide + i % kTileSide)];
}

double energy_at(const Sheet& sheet, int i, int j) {
  const std::size_t tile = static_cast<std::size_t>(j / kTileSide * sheet.grid().tiles_x()) +
                           static_cast<std::size_t>(i / kTileSide);
  const Sheet::Energy* const cells = sheet.energy(tile);
  return cells == nullptr
             ? 0
             : static_cast<double>(
                   (*cells)[static_cast<std::size_t>(j % kTileSide * kTileSide + i % kTileSide)]);
}

TEST(SheetOracle, OutlineOfASquare) {
  Sheet sheet = sheet_of(square(-10, 30), kKerf / 4);
  sheet.cut(outline(0, 20));
  EXPECT_NEAR(sheet.cut_mm2() / 15.9914159, 1, 0.01);
  const Pieces pieces = pieces_of(sheet);
  ASSERT_EQ(pieces.count, 2U);
  EXPECT_TRUE(pieces.largest[0].is_held);
  EXPECT_FALSE(pieces.largest[1].is_held);
  EXPECT_NEAR(pieces.largest[1].area_mm2 / 392.04, 1, 0.001);
  EXPECT_NEAR(pieces.largest[1].extents.low.u, 0.1, 0.05);
  EXPECT_NEAR(pieces.largest[1].extents.high.v, 19.9, 0.05);
}

TEST(SheetOracle, WallsBetweenCellsCostNoArea) {
  for (const double shift : {0.0, 0.013, 0.025, 0.037}) {
    Sheet sheet = sheet_of(square(-10 + shift, 30 + shift), kKerf / 4);
    sheet.cut(outline(0, 20));
    const Pieces pieces = pieces_of(sheet);
    ASSERT_EQ(pieces.count, 2U);
    EXPECT_NEAR(pieces.largest[1].area_mm2 / 392.04, 1, 0.0005) << shift;
    EXPECT_NEAR(pieces.largest[0].area_mm2 + pieces.largest[1].area_mm2 + sheet.cut_mm2(), 1600,
                0.01);
  }
}

TEST(SheetOracle, Circle) {
  Sheet sheet = sheet_of(square(-15, 15), kKerf / 4);
  sheet.cut(std::vector{round({0, 0}, 10, 0, 2 * pi)});
  EXPECT_NEAR(sheet.cut_mm2() / 12.5663706, 1, 0.01);
  const Pieces pieces = pieces_of(sheet);
  ASSERT_EQ(pieces.count, 2U);
  EXPECT_NEAR(pieces.largest[1].area_mm2 / 307.907496, 1, 0.001);
}

TEST(SheetOracle, CoarseCellsKeepArea) {
  for (const double cell : {0.2, 0.4, 0.5}) {
    Sheet sheet = sheet_of(square(-15, 15), cell);
    sheet.cut(std::vector{round({0, 0}, 10, 0, 2 * pi)});
    EXPECT_NEAR(sheet.cut_mm2() / 12.5663706, 1, 0.03) << cell;
    EXPECT_EQ(pieces_of(sheet).count, 2U) << cell;
  }
}

constexpr double kSpot = 0.1;
constexpr double kLineEnergy = 60 * 0.8 / 100;  // 60 W, 80 %, 100 mm/s: J/mm

/// A cut in periods of 1 ms along Y 0 whose middle cells have their middles at Y 0.
Sheet burnt_line(double cell, double to_x, unsigned jobs = 1) {
  const double half = cell * 64.5;
  Sheet sheet(grid_of({{0, -half}, {4, half}}, cell),
              {.kerf_mm = kSpot, .spot_mm = kSpot, .jobs = jobs});
  std::vector<Burn> burns;
  for (double x = 1; x < to_x - 0.05; x += 0.1) {
    burns.push_back({{x, 0}, {x + 0.1, 0}, kLineEnergy * 0.1});
  }
  sheet.burn(burns);
  return sheet;
}

TEST(SheetOracle, FluenceOfASteadyCut) {
  const double cell = kSpot / 4;
  const Sheet sheet = burnt_line(cell, 3);
  const int middle_row = 64;
  const int i = static_cast<int>(2 / cell);
  EXPECT_NEAR(energy_at(sheet, i, middle_row), 6.11154982, 1e-5);
  EXPECT_NEAR(energy_at(sheet, i, middle_row + 1), 5.29275740, 1e-5);
  EXPECT_NEAR(energy_at(sheet, i, middle_row - 1), 5.29275740, 1e-5);
  EXPECT_EQ(energy_at(sheet, i, middle_row + 3), 0);
  EXPECT_NEAR(sheet.peak_j_mm2(), 6.11154982, 1e-5);
}

TEST(SheetOracle, FluenceAcrossAddsUpToTheLine) {
  const double cell = kSpot / 200;
  Sheet sheet(grid_of({{-0.3, -0.3}, {0.3, 0.3}}, cell), {.kerf_mm = kSpot, .spot_mm = kSpot});
  sheet.burn(std::vector<Burn>{{{-1, 0}, {1, 0}, 2 * kLineEnergy}});
  double across = 0;
  for (int j = 0; j < sheet.grid().ny; ++j) across += energy_at(sheet, sheet.grid().nx / 2, j);
  EXPECT_NEAR(across * sheet.grid().cell_y() / kLineEnergy, 1, 1e-3);
}

TEST(SheetOracle, ASpotThatStandsBurnsItsDisc) {
  const double cell = kSpot / 40;
  Sheet sheet(grid_of(square(-0.3, 0.3), cell), {.kerf_mm = kSpot, .spot_mm = kSpot});
  sheet.burn(std::vector<Burn>{{{0, 0}, {0, 0}, 15}});
  EXPECT_NEAR(sheet.energy_on_sheet_j(), 15, 0.15);
  EXPECT_NEAR(sheet.peak_j_mm2(), 15 / (pi / 4 * kSpot * kSpot), 1e-3);
}

TEST(Sheet, TwiceIsOnceForCoverageAndDoubleForEnergy) {
  Sheet once = burnt_line(kSpot / 4, 3);
  once.cut(outline(-0.5, 1.5));
  Sheet twice = burnt_line(kSpot / 4, 3);
  for (int pass = 0; pass < 2; ++pass) twice.cut(outline(-0.5, 1.5));
  for (double x = 1; x < 2.95; x += 0.1)
    twice.burn(std::vector<Burn>{{{x, 0}, {x + 0.1, 0}, kLineEnergy * 0.1}});
  EXPECT_GT(once.cut_mm2(), 0);
  EXPECT_EQ(twice.cut_mm2(), once.cut_mm2());
  for (int j = 0; j < once.grid().ny; ++j) {
    for (int i = 0; i < once.grid().nx; ++i)
      ASSERT_NEAR(energy_at(twice, i, j), 2 * energy_at(once, i, j), 1e-5);
  }
}

// Random ways.

class RandomWays {
 public:
  explicit RandomWays(unsigned seed) : source_(seed) {}
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(source_);
  }
  Vec2 place() { return {number(-12, 12), number(-12, 12)}; }
  Trace trace() {
    const double kind = number(0, 1);
    const Vec2 from = place();
    if (kind < 0.1) return straight(from, from);
    if (kind < 0.4) return straight(from, from + Vec2{number(-0.3, 0.3), number(-0.3, 0.3)});
    if (kind < 0.6) return straight(from, place());
    return round(from, number(0.01, 8), number(-4, 4), number(0.01, 7) * (kind < 0.8 ? 1 : -1));
  }

 private:
  std::mt19937 source_;
};

/// From a thousand points of it, and from its ends.
double distance_by_points(const Trace& trace, Vec2 place) {
  constexpr int kPoints = 1000;
  double least = 1e300;
  for (int n = 0; n <= kPoints; ++n) {
    const double share = static_cast<double>(n) / kPoints;
    Vec2 at = trace.from + share * (trace.to - trace.from);
    if (trace.radius > 0) {
      const Vec2 out = trace.from - trace.centre;
      const double angle = std::atan2(out.v, out.u) + share * trace.turn_rad;
      at = trace.centre + trace.radius * Vec2{std::cos(angle), std::sin(angle)};
    }
    least = std::min(least, std::hypot(place.u - at.u, place.v - at.v));
  }
  return least;
}

TEST(Trace, DistanceIsThatOfItsPoints) {
  RandomWays random(7);
  for (int n = 0; n < 3000; ++n) {
    const Trace trace = random.trace();
    const Vec2 place = random.place();
    const double step = length(trace) / 1000;
    const double by_points = distance_by_points(trace, place);
    const double exact = distance(trace, place);
    EXPECT_LE(exact, by_points + 1e-9);
    EXPECT_GE(exact, by_points - step - 1e-9);
  }
}

TEST(Sheet, CoversWhatBruteForceCovers) {
  for (const double cell : {0.05, 0.11}) {
    RandomWays random(11);
    std::vector<Trace> traces;
    for (int n = 0; n < 60; ++n) traces.push_back(random.trace());
    Sheet sheet = sheet_of({{-10, -9}, {10.3, 9}}, cell, 0.17);
    sheet.cut(traces);
    const Grid& grid = sheet.grid();
    int differ = 0;
    for (int j = 0; j < grid.ny; ++j) {
      for (int i = 0; i < grid.nx; ++i) {
        double nearest = 1e300;
        for (const Trace& trace : traces)
          nearest = std::min(nearest, distance(trace, {grid.x(i), grid.y(j)}));
        const int wanted = covered(nearest, 0.17, grid.cell());
        const int got = coverage_at(sheet, i, j);
        ASSERT_NEAR(got, wanted, 1);  // the last bit of a rounding
        differ += got != wanted ? 1 : 0;
      }
    }
    EXPECT_LT(differ, 10);
  }
}

TEST(Sheet, DoesNotDependOnThreadsNorOnHowWaysAreDivided) {
  RandomWays random(3);
  std::vector<Trace> traces;
  std::vector<Burn> burns;
  for (int n = 0; n < 3000; ++n) {
    traces.push_back(random.trace());
    const Vec2 from = random.place();
    burns.push_back({from, from + Vec2{random.number(-1, 1), random.number(-1, 1)}, 0.1});
  }
  const auto made = [&](unsigned jobs, std::size_t at_once) {
    Sheet sheet(grid_of(square(-10, 10), 0.05), {.kerf_mm = 0.1, .spot_mm = 0.15, .jobs = jobs});
    for (std::size_t n = 0; n < traces.size(); n += at_once) {
      const std::size_t some = std::min(at_once, traces.size() - n);
      sheet.cut(std::span(traces).subspan(n, some));
      sheet.burn(std::span(burns).subspan(n, some));
    }
    return sheet;
  };
  const Sheet first = made(1, 3000);
  for (const unsigned jobs : {2U, 7U}) {
    const Sheet other = made(jobs, jobs == 2 ? 3000 : 1234);
    for (std::size_t tile = 0; tile < first.grid().tiles(); ++tile) {
      ASSERT_EQ(first.coverage(tile) == nullptr, other.coverage(tile) == nullptr);
      if (first.coverage(tile) == nullptr) continue;
      ASSERT_EQ(*first.coverage(tile), *other.coverage(tile));
      ASSERT_EQ(*first.energy(tile), *other.energy(tile));
    }
    EXPECT_EQ(first.cut_mm2(), other.cut_mm2());
    EXPECT_EQ(first.energy_on_sheet_j(), other.energy_on_sheet_j());
  }
}

TEST(Sheet, DividedWaysCoverTheSame) {
  Sheet whole = sheet_of(square(-10, 10), 0.05);
  Sheet parts = sheet_of(square(-10, 10), 0.05);
  whole.cut(std::vector{round({1, 2}, 5, 0.3, 2), straight({-4, -3}, {5, 1})});
  parts.cut(std::vector{round({1, 2}, 5, 0.3, 0.7), round({1, 2}, 5, 1, 1.3),
                        straight({-4, -3}, {-1, -5.0 / 3}), straight({-1, -5.0 / 3}, {5, 1})});
  EXPECT_NEAR(whole.cut_mm2(), parts.cut_mm2(), 1e-4);
}

TEST(Sheet, HoldsOnlyTilesThatWaysComeTo) {
  Sheet sheet = sheet_of(square(0, 1000), 0.05);
  sheet.cut(std::vector{straight({10, 10.01}, {990, 980})});
  const double per_side = 1000 / (0.05 * kTileSide);
  EXPECT_LT(static_cast<double>(sheet.touched_tiles()), 2.2 * per_side);
  EXPECT_NEAR(sheet.cut_mm2(), kKerf * std::hypot(980, 969.99), 0.1);
}

TEST(Sheet, ABudgetLeavesTilesOutAndCountsThem) {
  Sheet sheet(grid_of(square(0, 1000), 0.05), {.kerf_mm = kKerf, .memory_bytes = 1 << 20});
  sheet.cut(std::vector{straight({10, 10}, {990, 980})});
  EXPECT_GT(sheet.missing_tiles(), 400U);
  EXPECT_LE(sheet.bytes(), 1U << 20);
}

TEST(Sheet, CellsOfAHugeSheetGrowToFit) {
  const Box table = square(0, 100'000);
  const std::size_t memory = 64UL << 20;
  const double cell = fitting_cell(table, 0.001, memory);
  EXPECT_GT(cell, 0.001);
  Sheet sheet(grid_of(table, cell), {.kerf_mm = kKerf, .memory_bytes = memory});
  sheet.cut(std::vector{straight({10, 10}, {11, 10})});
  EXPECT_LE(sheet.bytes(), memory);
  EXPECT_EQ(fitting_cell(square(0, 100), 0.05, memory), 0.05);
  EXPECT_LE(fitting_cell(table, 1e-300, 1), 100'000);
}

TEST(Sheet, LeavesOutWhatIsNoPlace) {
  Sheet sheet = sheet_of(square(0, 10), 0.05);
  const double none = std::nan("");
  const double far = std::numeric_limits<double>::infinity();
  sheet.cut(std::vector{straight({none, 0}, {1, 1}), straight({0, 0}, {far, 1}),
                        straight({1e300, 0}, {-1e300, 1}), straight({-500, -500}, {-400, -400})});
  EXPECT_EQ(sheet.missing_tiles(), 0U);
  EXPECT_TRUE(std::isfinite(sheet.cut_mm2()));
}

}  // namespace
}  // namespace kerf::stock::sheet
