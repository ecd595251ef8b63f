// What falls out of a sheet.
#include "stock/sheet/pieces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace kerf::stock::sheet {
namespace {

using std::numbers::pi;

constexpr double kKerf = 0.2;
constexpr double kCell = 0.05;

Sheet sheet_of(double from, double to, double cell = kCell) {
  return Sheet(grid_of({{from, from}, {to, to}}, cell), {.kerf_mm = kKerf});
}

void cut_square(Sheet& sheet, Vec2 middle, double half) {
  const Vec2 a = middle + Vec2{-half, -half};
  const Vec2 b = middle + Vec2{half, -half};
  const Vec2 c = middle + Vec2{half, half};
  const Vec2 d = middle + Vec2{-half, half};
  sheet.cut(std::vector{straight(a, b), straight(b, c), straight(c, d), straight(d, a)});
}

TEST(Pieces, AWholeSheetIsOneThatIsHeld) {
  const Pieces pieces = pieces_of(sheet_of(0, 37));
  ASSERT_EQ(pieces.count, 1U);
  EXPECT_TRUE(pieces.largest[0].is_held);
  EXPECT_NEAR(pieces.largest[0].area_mm2, 37 * 37, 1e-9);
  EXPECT_NEAR(pieces.largest[0].extents.high.u, 37, 1e-9);
}

TEST(Pieces, NestedSquaresFallOutOneInTheOther) {
  Sheet sheet = sheet_of(-20, 20);
  for (const double half : {15.0, 10.0, 5.0}) cut_square(sheet, {0, 0}, half);
  const Pieces pieces = pieces_of(sheet);
  ASSERT_EQ(pieces.count, 4U);
  const auto inside = [](double half) { return std::pow(2 * half - kKerf, 2); };
  const auto around = [](double half) {  // outer corners of the kerf are round
    return std::pow(2 * half + kKerf, 2) - (4 - pi) * kKerf * kKerf / 4;
  };
  EXPECT_NEAR(pieces.largest[0].area_mm2, 1600 - around(15), 0.1);
  EXPECT_NEAR(pieces.largest[1].area_mm2, inside(15) - around(10), 0.1);
  EXPECT_NEAR(pieces.largest[2].area_mm2, inside(10) - around(5), 0.1);
  EXPECT_NEAR(pieces.largest[3].area_mm2, inside(5), 0.1);
  EXPECT_TRUE(pieces.largest[0].is_held);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_FALSE(pieces.largest[i].is_held);
}

TEST(Pieces, ARingAndItsDisc) {
  Sheet sheet = sheet_of(-15, 15);
  sheet.cut(std::vector{round({0, 0}, 12, 1, 2 * pi), round({0, 0}, 4, 0, -2 * pi)});
  const Pieces pieces = pieces_of(sheet);
  ASSERT_EQ(pieces.count, 3U);
  const auto disc = [](double r) { return pi * r * r; };
  EXPECT_NEAR(pieces.largest[1].area_mm2, disc(11.9) - disc(4.1), 0.1);
  EXPECT_NEAR(pieces.largest[0].area_mm2, 900 - disc(12.1), 0.1);
  EXPECT_NEAR(pieces.largest[2].area_mm2, disc(3.9), 0.05);
}

TEST(Pieces, ABridgeHoldsAPiece) {
  Sheet sheet = sheet_of(-15, 15);
  sheet.cut(std::vector{round({0, 0}, 10, 0, 2 * pi - 0.06)});  // 0.6 mm on the path
  ASSERT_EQ(pieces_of(sheet).count, 1U);
  EXPECT_TRUE(pieces_of(sheet).largest[0].is_held);
  sheet.cut(std::vector{round({0, 0}, 10, 0, -0.06)});
  EXPECT_EQ(pieces_of(sheet).count, 2U);
}

TEST(Pieces, LinesThroughTheSheetDivideIt) {
  Sheet sheet = sheet_of(0, 30);
  sheet.cut(std::vector{straight({10, -1}, {10, 31}), straight({-1, -1}, {31, 31})});
  const Pieces pieces = pieces_of(sheet);
  ASSERT_EQ(pieces.count, 4U);
  for (const Piece& piece : pieces.largest) EXPECT_TRUE(piece.is_held);
}

TEST(Pieces, EqualOnesComeByTheirPlace) {
  Sheet sheet = sheet_of(0, 40);
  for (const double x : {30.0, 10.0, 20.0}) cut_square(sheet, {x, 20}, 3);
  const Pieces pieces = pieces_of(sheet);
  ASSERT_EQ(pieces.count, 4U);
  EXPECT_LT(pieces.largest[1].extents.low.u, pieces.largest[2].extents.low.u);
  EXPECT_LT(pieces.largest[2].extents.low.u, pieces.largest[3].extents.low.u);
}

TEST(Pieces, OnlyTheLargestAreKept) {
  Sheet sheet = sheet_of(0, 100, 0.1);
  int made = 0;
  for (double y = 1; y < 99; y += 2) {
    for (double x = 1; x < 99; x += 2, ++made) cut_square(sheet, {x, y}, 0.6);
  }
  const Pieces pieces = pieces_of(sheet);
  EXPECT_EQ(pieces.count, static_cast<std::uint64_t>(made) + 1);
  EXPECT_EQ(pieces.largest.size(), Pieces::kMost);
}

/// By filling cell after cell over the whole sheet.
std::vector<std::uint64_t> by_filling(const Sheet& sheet) {
  const Grid& grid = sheet.grid();
  const auto covered = [&](int i, int j) -> int {
    const auto* const cells =
        sheet.coverage(static_cast<std::size_t>(j / kTileSide * grid.tiles_x() + i / kTileSide));
    return cells == nullptr
               ? 0
               : (*cells)[static_cast<std::size_t>(j % kTileSide * kTileSide + i % kTileSide)];
  };
  std::vector<bool> seen(static_cast<std::size_t>(grid.nx * grid.ny));
  std::vector<std::uint64_t> sizes;
  std::vector<std::pair<int, int>> waiting;
  const auto visit = [&](int i, int j) {
    if (i < 0 || j < 0 || i >= grid.nx || j >= grid.ny) return;
    const auto place = static_cast<std::size_t>(j * grid.nx + i);
    if (seen[place] || covered(i, j) >= sheet.cut_from()) return;
    seen[place] = true;
    ++sizes.back();
    waiting.emplace_back(i, j);
  };
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) {
      sizes.push_back(0);
      visit(i, j);
      while (!waiting.empty()) {
        const auto [x, y] = waiting.back();
        waiting.pop_back();
        visit(x + 1, y);
        visit(x - 1, y);
        visit(x, y + 1);
        visit(x, y - 1);
      }
      if (sizes.back() == 0) sizes.pop_back();
    }
  }
  std::sort(sizes.rbegin(), sizes.rend());
  return sizes;
}

TEST(Pieces, AreThoseThatFillingFinds) {
  std::mt19937 source(5);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(source);
  };
  for (int trial = 0; trial < 20; ++trial) {
    Sheet sheet = sheet_of(0, number(15, 25));
    std::vector<Trace> traces;
    for (int n = 0; n < 40; ++n) {
      const Vec2 at{number(0, 25), number(0, 25)};
      if (n % 2 == 0) {
        traces.push_back(round(at, number(0.2, 5), 0, 7));
      } else {
        traces.push_back(straight(at, {number(0, 25), number(0, 25)}));
      }
    }
    sheet.cut(traces);
    const Pieces pieces = pieces_of(sheet);
    const std::vector<std::uint64_t> sizes = by_filling(sheet);
    ASSERT_EQ(pieces.count, sizes.size());
    double whole = 0;
    double filled = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      whole += pieces.largest[i].area_mm2;
      filled += static_cast<double>(sizes[i]) * sheet.grid().cell_mm2();
    }
    EXPECT_NEAR(whole / filled, 1, 0.01);
    const double all = std::pow(sheet.grid().box.high.u, 2);
    EXPECT_LE(whole + sheet.cut_mm2(), all * (1 + 1e-12));
    EXPECT_NEAR(whole + sheet.cut_mm2(), all, 0.001 * all);
  }
}

}  // namespace
}  // namespace kerf::stock::sheet
