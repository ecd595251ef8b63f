#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <numbers>

#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"
#include "geometry/contour/relation.hpp"
#include "geometry/contour/sweep.hpp"
#include "random_shapes.hpp"
#include "shapes.hpp"

namespace kerf::contour {
namespace {

using namespace test;  // NOLINT: shapes by their names
using std::numbers::pi;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Nonsense, OfNumbersIsLeftOut) {
  for (const double bad : {kNan, kInfinity, -kInfinity, 1e300}) {
    Contour by_point = rectangle(0, 0, 10, 10);
    by_point.vertices[2].point.u = bad;
    Contour by_bulge = rectangle(0, 0, 10, 10);
    by_bulge.vertices[1].bulge = bad;
    for (const Contour& contour : {by_point, by_bulge}) {
      EXPECT_TRUE(region_of(contour).is_empty()) << bad;
      expect_near(areas(region_of({contour, rectangle(20, 0, 30, 10)})), {100}, 1e-9);
      EXPECT_TRUE(sweep_of_disc(contour, 5).is_empty()) << bad;
    }
    const Region square = region_of(rectangle(0, 0, 10, 10));
    EXPECT_EQ(offset(square, bad), square);
    EXPECT_TRUE(sweep_of_disc(rectangle(0, 0, 10, 10), bad).is_empty());
  }
}

TEST(Nonsense, WithoutAreaIsEmpty) {
  EXPECT_TRUE(region_of(Contour{}).is_empty());
  EXPECT_TRUE(region_of(closed({{{1, 2}, 1}})).is_empty());
  EXPECT_TRUE(region_of(closed({{{1, 2}}, {{5, 7}}})).is_empty());
  EXPECT_TRUE(region_of(closed({{{1, 2}, 1}, {{1, 2}, -1}})).is_empty());
  EXPECT_TRUE(region_of(closed({{{0, 0}}, {{10, 0}}, {{20, 0}}, {{5, 0}}})).is_empty());
  EXPECT_TRUE(region_of(closed({{{0, 0}, 0.3}, {{10, 0}, -0.3}})).is_empty());
  EXPECT_TRUE(region_of(open({{{0, 0}}, {{10, 0}}, {{10, 10}}})).is_empty());
  EXPECT_TRUE(offset(Region{}, 5).is_empty());
  EXPECT_TRUE(unite(Region{}, Region{}).is_empty());
  EXPECT_TRUE(disc({0, 0}, 0).is_empty());
}

TEST(Nonsense, OfVerticesThatComeTwiceChangesNothing) {
  const Contour shape = closed({{{0, 0}},
                                {{0, 0}, 1},
                                {{40, 0}},
                                {{40, 0}},
                                {{40, 1e-10}},
                                {{40, 30}},
                                {{40, 30}},
                                {{0, 30}}});
  const Region twice = region_of(shape);
  const Region once = region_of(closed({{{0, 0}, 1}, {{40, 0}}, {{40, 30}}, {{0, 30}}}));
  expect_near(areas(twice), areas(once), 1e-7);
  EXPECT_EQ(vertex_count(twice), vertex_count(once));
}

TEST(Region, OfAnyTurnsIsWhatIsGoneRoundAtAll) {
  expect_near(areas(region_of(reversed(rect40x30()))), {1200}, 1e-9);
  Contour twice = circle20();
  twice.vertices.insert(twice.vertices.end(), {{{-20, 0}, 1}, {{20, 0}, 1}});
  expect_near(areas(region_of(twice)), {400 * pi}, 1e-9);
  // An eight: one half in each sense.
  const Contour eight = closed({{{0, 0}}, {{10, 10}}, {{10, 0}}, {{0, 10}}});
  expect_near(areas(region_of(eight)), {25, 25}, 1e-9);
}

TEST(Region, HasNoSpurs) {
  const Contour spur = closed({{{0, 0}}, {{20, 0}}, {{50, 0}}, {{20, 0}}, {{20, 10}}, {{0, 10}}});
  const Region region = region_of(spur);
  expect_near(areas(region), {200}, 1e-9);
  EXPECT_EQ(vertex_count(region), 4U);
}

TEST(Region, OfANearlyFullCircleKeepsIt) {
  const Contour keyhole = closed({{{10, 1e-4}, std::tan((2 * pi - 2e-5) / 4)}, {{10, -1e-4}}});
  const Region region = region_of(keyhole);
  ASSERT_EQ(region.loops.size(), 1U);
  EXPECT_NEAR(area(region), area(keyhole), 1e-6);
}

TEST(Boolean, OfWhatRunsBesideItselfLeavesNoSliver) {
  const Region bar = region_of(rectangle(0, 0, 100, 10));
  for (const double aside : {0.0, 1e-11, 4e-10, -4e-10, 9e-10}) {
    const Region beside = region_of(rectangle(20, aside, 70, 10 + aside));
    EXPECT_EQ(unite(bar, beside).loops.size(), 1U) << aside;
    EXPECT_EQ(subtract(bar, beside).loops.size(), 2U) << aside;
    EXPECT_TRUE(subtract(beside, bar).is_empty()) << aside;
    const Region ring = disc({0, 0}, 30);
    EXPECT_TRUE(symmetric_difference(ring, disc({aside, 0}, 30)).is_empty()) << aside;
    EXPECT_TRUE(subtract(disc({0, 0}, 30 + aside / 2), ring).is_empty()) << aside;
  }
}

TEST(Boolean, OfArcsOfOneCircleJoinsThem) {
  const Region lower = region_of(closed({{{-20, 0}, 1}, {{20, 0}}}));
  Region sector = region_of(closed({{{0, 0}}, {{12, -16}, 0.5}, {{12 * 0.28 + 16 * 0.96, 0}}}));
  EXPECT_FALSE(sector.is_empty());
  const Region upper = region_of(closed({{{20, 0}, 1}, {{-20, 0}}}));
  expect_near(areas(unite(lower, upper)), {400 * pi}, 1e-9);
  EXPECT_LE(vertex_count(unite(lower, upper)), 3U);
}

TEST(Offset, OfIslandsWithACommonTangentMergesThem) {
  const Region two = unite(disc({0, 0}, 5), disc({12, 0}, 5));
  EXPECT_EQ(offset(two, 0.999999).loops.size(), 2U);
  expect_near(areas(offset(two, 1)), {36 * pi, 36 * pi}, 1e-6);
  EXPECT_EQ(offset(two, 1.000001).loops.size(), 1U);
}

TEST(Offset, WallsVanishAndHolesClose) {
  const Region wall =
      subtract(region_of(rectangle(0, 0, 60, 40)),
               unite(region_of(rectangle(5, 5, 29, 35)), region_of(rectangle(31, 5, 55, 35))));
  EXPECT_EQ(wall.loops.size(), 3U);
  EXPECT_EQ(offset(wall, -0.999).loops.size(), 3U);
  EXPECT_EQ(offset(wall, -1).loops.size(), 2U);
  EXPECT_EQ(offset(wall, -1.001).loops.size(), 2U);
  EXPECT_EQ(offset(wall, 12).loops.size(), 1U);
}

TEST(Offset, PassesOverNotchesOfTenNanometres) {
  Contour shape{{}, true};
  for (int i = 0; i < 200; ++i) {
    const double x = 0.5 * i;
    shape.vertices.insert(shape.vertices.end(),
                          {{{x, 0}}, {{x, 1e-5}}, {{x + 1e-5, 1e-5}}, {{x + 1e-5, 0}}});
  }
  shape.vertices.insert(shape.vertices.end(), {{{100, 0}}, {{100, 50}}, {{0, 50}}});
  const Region inside = offset(region_of(shape), -5);
  ASSERT_EQ(inside.loops.size(), 1U);
  EXPECT_NEAR(area(inside), 90 * 40, 90 * 2e-5);
  EXPECT_NEAR(area(offset(region_of(shape), 5)), 5000 + 300 * 5 + 25 * pi, 1e-3);
}

// --- 100,000 vertices ----------------------------------------------------------------------------

// How much longer than the ordinary work of as many vertices: a quadratic step takes thousands of
// times.
constexpr double kMostTimes = 100;

/// Of the processor: what else the computer does is none of it.
double seconds_of(const std::function<void()>& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

constexpr int kMany = 100'000;

Contour large_star(double inner, double outer) {
  Contour contour;
  for (int i = 0; i < kMany; ++i) {
    const double angle = 2 * pi * i / kMany;
    const double reach = i % 2 == 0 ? outer : inner;
    contour.vertices.push_back({{reach * std::cos(angle), reach * std::sin(angle)}});
  }
  return contour;
}

/// A disc of as many vertices as all others have, made and grown.
double ordinary_seconds() {
  static const double seconds =
      seconds_of([] { EXPECT_FALSE(offset(region_of(large_star(100, 100)), 1).is_empty()); });
  return seconds;
}

Contour comb(double angle_rad) {
  Contour contour;
  for (int i = 0; i < kMany / 4; ++i) {
    const double x = 4e-3 * i;
    contour.vertices.insert(contour.vertices.end(),
                            {{{x, 0}}, {{x, -100}}, {{x + 2e-3, -100}}, {{x + 2e-3, 0}}});
  }
  contour.vertices.insert(contour.vertices.end(), {{{100, 0}}, {{100, 5}}, {{0, 5}}});
  return mapped(contour, angle_rad, {3, 4});
}

Contour spiral() {
  Contour contour;
  const auto wind = [&](int i, double aside) {
    const double angle = 2 * pi * 200 * i / (kMany / 2.0);
    const double reach = 2 + 100 * i / (kMany / 2.0) + aside;
    contour.vertices.push_back({{reach * std::cos(angle), reach * std::sin(angle)}});
  };
  for (int i = 0; i < kMany / 2; ++i) wind(i, 0);
  for (int i = kMany / 2; i-- > 0;) wind(i, 0.15);
  return contour;
}

TEST(Large, CombsSpiralsAndStarsAreNotQuadratic) {
  const double seconds = seconds_of([] {
    for (const double angle : {0.0, 0.7}) {
      const Region teeth = region_of(comb(angle));
      EXPECT_EQ(teeth.loops.size(), 1U);
      EXPECT_NEAR(area(teeth), 500 + 25'000 * 0.2, 1e-5);
      EXPECT_NEAR(area(offset(teeth, -1e-4)), 4999.97911, 1e-4);
    }
    EXPECT_EQ(offset(region_of(spiral()), 0.05).loops.size(), 1U);
    EXPECT_EQ(vertex_count(region_of(large_star(5, 100))), std::size_t{kMany});
  });
  EXPECT_LT(seconds, kMostTimes * ordinary_seconds());
}

TEST(Large, CirclesOfLinesShrinkToNothingWithoutAKnot) {
  const double seconds = seconds_of([] {
    const Region round = region_of(large_star(100, 100));
    const double share = 0.5 / std::cos(pi / kMany);
    EXPECT_NEAR(area(offset(round, -50)), area(round) * share * share, 1e-3);
    EXPECT_TRUE(offset(round, -100.1).is_empty());
    EXPECT_TRUE(offset(round, -200).is_empty());
  });
  EXPECT_LT(seconds, kMostTimes * ordinary_seconds());
}

TEST(Large, ManyEqualEdgesAreOne) {
  const double seconds = seconds_of([] {
    std::vector<Region> grid;
    std::vector<Region> pile;
    std::vector<Region> row;
    for (int i = 0; i < kMany / 4; ++i) {
      const double x = i % 158;
      const double y = static_cast<double>(i / 158);
      grid.push_back({{rectangle(x, y, x + 1, y + 1)}});
      pile.push_back({{rectangle(0, 0, 1, 1)}});
      row.push_back({{rectangle(0.25 * i, 0, 0.25 * i + 1, 1)}});
    }
    EXPECT_NEAR(area(unite(grid)), kMany / 4.0, 1e-6);
    EXPECT_EQ(vertex_count(unite(pile)), 4U);
    EXPECT_EQ(vertex_count(unite(row)), 4U);
  });
  EXPECT_LT(seconds, kMostTimes * ordinary_seconds());
}

TEST(Large, LoopsInLoopsKeepTheirPlaces) {
  Region rings;
  for (int i = 0; i < 5000; ++i) {
    const double half = 1 + i * 0.01;
    const Contour square = rectangle(-half, -half, half, half);
    rings.loops.push_back(i % 2 == 0 ? reversed(square) : square);
  }
  const double seconds = seconds_of([&] {
    const Region same = unite(rings, Region{});
    EXPECT_EQ(same.loops.size(), 5000U);
    EXPECT_NEAR(area(same), area(rings), 1e-6);
  });
  EXPECT_LT(seconds, kMostTimes * ordinary_seconds());
}

}  // namespace
}  // namespace kerf::contour
