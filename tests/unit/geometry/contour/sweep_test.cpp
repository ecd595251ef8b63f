#include "geometry/contour/sweep.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"
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
