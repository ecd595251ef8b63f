#include "geometry/contour/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"
#include "seeded_random.hpp"
#include "shapes.hpp"

namespace kerf::contour {
namespace {

using namespace test;  // NOLINT: shapes by their names
using std::numbers::pi;

TEST(SweepOfDisc, AlongALineIsACapsule) {
  const Region capsule = sweep_of_disc(open({{{0, 0}, 0, 3}, {{30, 40}}}), 5);
  expect_near(areas(capsule), {500 + 25 * pi}, 1e-9);
  EXPECT_EQ(vertex_count(capsule), 4U);
  for (const Vertex& vertex : capsule.loops.front().vertices) EXPECT_EQ(vertex.owner, 3U);
}

TEST(SweepOfDisc, AlongAnArcIsAnAnnularSectorWithRoundEnds) {
  const Contour quarter = open({{{20, 0}, kQuarter}, {{0, 20}}});
  expect_near(areas(sweep_of_disc(quarter, 5)), {pi / 4 * (625 - 225) + 25 * pi}, 1e-9);
}

TEST(SweepOfDisc, AlongASmallArcCoversItsCentre) {
  // A disc of 5 about each point of a half circle of 3: nothing is left uncovered inside.
  const Region swept = sweep_of_disc(open({{{3, 0}, 1}, {{-3, 0}}}), 5);
  ASSERT_EQ(swept.loops.size(), 1U);
  for (const Vec2 inside : {Vec2{0, 0}, Vec2{0, -2}, Vec2{0, 7.9}, Vec2{7.9, 0}, Vec2{0, -3.9}}) {
    EXPECT_EQ(side_of(swept, inside, 0), Side::inside) << inside.u << ", " << inside.v;
  }
  EXPECT_EQ(side_of(swept, {0, -4.1}, 0), Side::outside);
}

TEST(SweepOfDisc, AlongAClosedPathIsARing) {
  expect_near(areas(sweep_of_disc(circle20(), 5)), {625 * pi, -225 * pi}, 1e-9);
  expect_near(areas(sweep_of_disc(circle20(), 20)), {1600 * pi}, 1e-9);
}

Vec2 rounded(Vec2 point) {
  return {std::round(point.u * 1000) / 1000, std::round(point.v * 1000) / 1000};
}

/// The way of a tool round a sharp rectangle as a program has it: words of three decimals.
Contour way_round(const std::vector<Vec2>& island, double radius) {
  Contour way{{}, true};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 corner = island[i];
    const Vec2 before = geometry::unit(corner - island[(i + 3) % 4]);
    const Vec2 behind = geometry::unit(island[(i + 1) % 4] - corner);
    const Vec2 from = rounded(corner - radius * geometry::left_of(before));
    const Vec2 to = rounded(corner - radius * geometry::left_of(behind));
    const Vec2 first = from - rounded(corner);
    const Vec2 last = to - rounded(corner);
    way.vertices.push_back({from, std::tan(std::atan2(cross(first, last), dot(first, last)) / 4)});
    way.vertices.push_back({to});
  }
  return way;
}

// Beside arcs of some ten nanometres lines of many millimetres cross at next to no angle.
TEST(SweepOfDisc, RoundASharpIslandLeavesItWithRoundedWords) {
  for (unsigned seed = kerf::test::kSeed; seed != kerf::test::kSeed + 400; ++seed) {
    kerf::test::SeededRandom random(seed);
    const Vec2 middle{random.in(20, 80), random.in(20, 80)};
    const double angle = random.in(0, 2 * pi);
    const Vec2 along = random.in(5, 20) * Vec2{std::cos(angle), std::sin(angle)};
    const Vec2 across = random.in(5, 20) * Vec2{-std::sin(angle), std::cos(angle)};
    const std::vector<Vec2> island{middle - along - across, middle + along - across,
                                   middle + along + across, middle - along + across};
    const double radius = std::round(random.in(2, 6) * 200) / 200;
    const Region swept = sweep_of_disc(way_round(island, radius), radius);
    ASSERT_EQ(swept.loops.size(), 2U) << seed;
    const double left = -std::min(area(swept.loops[0]), area(swept.loops[1]));
    EXPECT_NEAR(left, 4 * geometry::length(along) * geometry::length(across), 0.2) << seed;
  }
}

TEST(SweepOfDisc, OfOnePointIsADisc) {
  expect_near(areas(sweep_of_disc(open({{{1, 2}}}), 5)), {25 * pi}, 1e-9);
  expect_near(areas(sweep_of_disc(open({{{1, 2}}, {{1, 2}}, {{1, 2}}}), 5)), {25 * pi}, 1e-9);
}

TEST(SweepOfDisc, ForthAndBackIsTheSameAsOnce) {
  const Contour once = open({{{0, 0}}, {{30, 0}}, {{30, 20}}});
  const Contour twice = open({{{0, 0}}, {{30, 0}}, {{30, 20}}, {{30, 0}}, {{0, 0}}});
  expect_near(areas(sweep_of_disc(twice, 4)), areas(sweep_of_disc(once, 4)), 1e-9);
}

TEST(SweepOfDisc, OfManyPassesIsTheUnionOfTheirCapsules) {
  Contour zigzag{{}, false};
  std::vector<Region> capsules;
  for (int i = 0; i < 20; ++i) {
    const double y = 3 * (i / 2);
    zigzag.vertices.push_back({{(i % 4 == 1 || i % 4 == 2) ? 50.0 : 0.0, y}});
    if (i > 0) {
      capsules.push_back(sweep_of_disc(
          open({zigzag.vertices[zigzag.vertices.size() - 2], zigzag.vertices.back()}), 2));
    }
  }
  expect_near(areas(sweep_of_disc(zigzag, 2)), areas(unite(capsules)), 1e-9);
}

TEST(SweepAlong, ALineOfADiscIsACapsuleToo) {
  const Region swept = sweep_along(disc({0, 0}, 5), {30, 40});
  expect_near(areas(swept), {500 + 25 * pi}, 1e-9);
  EXPECT_EQ(vertex_count(swept), 4U);
}

TEST(SweepAlong, AStepOfARectangleIsAHexagon) {
  expect_near(areas(sweep_along(region_of(rectangle(0, 0, 4, 3)), {10, 5})), {12 + 4 * 5 + 3 * 10},
              1e-9);
}

TEST(SweepAlong, ARingLeavesWhatItsHoleNeverLeaves) {
  const Region ring = subtract(disc({0, 0}, 20), disc({0, 0}, 10));
  const Region lens = intersect(disc({0, 0}, 10), disc({12, 0}, 10));
  expect_near(areas(sweep_along(ring, {12, 0})), {400 * pi + 40 * 12, -area(lens)}, 1e-9);
}

TEST(Parallel, OfAnOpenContourKeepsItsSideAndDirection) {
  const Contour path = open({{{0, 0}, 0, 1}, {{30, 0}, 0, 2}, {{30, 20}}});
  const auto right = parallel(path, 5);
  ASSERT_EQ(right.size(), 1U);
  ASSERT_EQ(right[0].vertices.size(), 4U);
  EXPECT_EQ(right[0].vertices[0], (Vertex{{0, -5}, 0, 1}));
  EXPECT_EQ(right[0].vertices[1].point, (Vec2{30, -5}));
  EXPECT_NEAR(right[0].vertices[1].bulge, kQuarter, 1e-12);
  EXPECT_EQ(right[0].vertices[2], (Vertex{{35, 0}, 0, 2}));
  EXPECT_EQ(right[0].vertices[3].point, (Vec2{35, 20}));
  const auto left = parallel(path, -5);
  ASSERT_EQ(left.size(), 1U);
  ASSERT_EQ(left[0].vertices.size(), 3U);
  EXPECT_EQ(left[0].vertices[0], (Vertex{{0, 5}, 0, 1}));
  EXPECT_EQ(left[0].vertices[1], (Vertex{{25, 5}, 0, 2}));
  EXPECT_EQ(left[0].vertices[2].point, (Vec2{25, 20}));
}

TEST(Parallel, IsInterruptedWhereTheContourComesTooNear) {
  // A notch of 6 mm: at 5 mm nothing of its walls is left.
  const Contour notch = open({{{0, 0}}, {{20, 0}}, {{20, -10}}, {{26, -10}}, {{26, 0}}, {{50, 0}}});
  const auto runs = parallel(notch, -5);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_NEAR(runs[0].vertices.front().point.v, 5, 1e-12);
  EXPECT_NEAR(runs[0].vertices.back().point.u, 50, 1e-12);
  for (const Vertex& vertex : runs[0].vertices) EXPECT_GT(vertex.point.v, 3.9);
}

}  // namespace
}  // namespace kerf::contour
