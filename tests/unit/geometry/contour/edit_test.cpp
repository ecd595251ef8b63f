#include "geometry/contour/edit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shapes.hpp"

namespace kerf::contour {
namespace {

using namespace test;  // NOLINT: shapes by their names

constexpr double kSixDecimals = 0.6e-6;

void expect_point(Vec2 actual, Vec2 expected) {
  EXPECT_NEAR(actual.u, expected.u, kSixDecimals);
  EXPECT_NEAR(actual.v, expected.v, kSixDecimals);
}

struct FilletRow {
  Vec2 p, corner, q;
  double radius;
  Vec2 begin, end, centre;
  double sweep_deg, bulge;
};
constexpr FilletRow kFillets[] = {
    {{0, 0}, {50, 0}, {80, 40}, 10, {45, 0}, {53, 4}, {45, 10}, 53.130102, 0.236068},
    {{0, 0}, {10, 0}, {10, 10}, 2, {8, 0}, {10, 2}, {8, 2}, 90, 0.414214},
    {{0, 10}, {0, 0}, {30, 0}, 4, {0, 4}, {4, 0}, {4, 4}, 90, 0.414214},
    {{0, 0},
     {20, 0},
     {5, 15},
     3,
     {12.757359, 0},
     {14.878680, 5.121320},
     {12.757359, 3},
     135,
     0.668179},
    {{0, 0},
     {20, 0},
     {40, 1},
     50,
     {18.750780, 0},
     {21.247661, 0.062383},
     {18.750780, 50},
     2.862405,
     0.012490}};

TEST(Fillet, HasThePointsOfTheTable) {
  for (const FilletRow& row : kFillets) {
    const Contour shape = open({{row.p, 0, 7}, {row.corner, 0, 8}, {row.q}});
    const Edited edited = fillet(shape, 1, row.radius);
    ASSERT_TRUE(edited);
    ASSERT_EQ(edited->vertices.size(), 4U);
    const Edge arc = edge_of(*edited, 1);
    expect_point(arc.from, row.begin);
    expect_point(arc.to, row.end);
    expect_point(centre(arc), row.centre);
    EXPECT_NEAR(sweep_rad(arc) * 180 / std::numbers::pi, row.sweep_deg, kSixDecimals);
    EXPECT_NEAR(arc.bulge, row.bulge, kSixDecimals);
    EXPECT_EQ(arc.owner, 7U);
    EXPECT_EQ(edge_of(*edited, 2).owner, 8U);
  }
}

struct ChamferRow {
  Vec2 p, corner, q;
  double before, after;
  Vec2 begin, end;
  double length;
};
constexpr ChamferRow kChamfers[] = {{{0, 0}, {50, 0}, {80, 40}, 5, 5, {45, 0}, {53, 4}, 8.944272},
                                    {{0, 0}, {10, 0}, {10, 10}, 2, 3, {8, 0}, {10, 3}, 3.605551},
                                    {{0, 10}, {0, 0}, {30, 0}, 4, 8, {0, 4}, {8, 0}, 8.944272}};

TEST(Chamfer, HasThePointsOfTheTable) {
  for (const ChamferRow& row : kChamfers) {
    const Edited edited = chamfer(open({{row.p}, {row.corner}, {row.q}}), 1, row.before, row.after);
    ASSERT_TRUE(edited);
    const Edge line = edge_of(*edited, 1);
    expect_point(line.from, row.begin);
    expect_point(line.to, row.end);
    EXPECT_NEAR(length(line), row.length, kSixDecimals);
  }
}

TEST(Fillet, TellsWhichEdgeIsTooShortAndByHowMuch) {
  const Edited edited = fillet(rectangle(0, 0, 40, 28), 1, 30);
  ASSERT_FALSE(edited);
  EXPECT_EQ(edited.error().edge, 1U);
  EXPECT_NEAR(edited.error().needs_mm, 30, 1e-9);
  EXPECT_NEAR(edited.error().has_mm, 28, 1e-9);
}

TEST(Chamfer, TellsWhichEdgeIsTooShortAndByHowMuch) {
  const Edited edited = chamfer(rectangle(0, 0, 40, 28), 0, 30, 5);
  ASSERT_FALSE(edited);
  EXPECT_EQ(edited.error().edge, 3U);
  EXPECT_NEAR(edited.error().needs_mm, 30, 1e-9);
  EXPECT_NEAR(edited.error().has_mm, 28, 1e-9);
}

TEST(Fillet, OfAllCornersOfARectangleTakesTheirAreas) {
  Contour shape = rectangle(0, 0, 40, 30);
  for (const std::size_t corner : {3U, 2U, 1U, 0U}) {
    Edited edited = fillet(shape, corner, 5);
    ASSERT_TRUE(edited);
    shape = *edited;
  }
  EXPECT_EQ(shape.vertices.size(), 8U);
  EXPECT_NEAR(area(shape), 1200 - (4 - std::numbers::pi) * 25, 1e-9);
}

TEST(Fillet, BetweenALineAndAnArcTouchesBoth) {
  // Half a disc: its corners lie between the diameter and the arc.
  const Contour half = closed({{{-20, 0}}, {{20, 0}, 1}});
  const Edited edited = fillet(half, 1, 4);
  ASSERT_TRUE(edited);
  const Edge arc = edge_of(*edited, 1);
  EXPECT_NEAR(centre(arc).v, 4, 1e-9);
  EXPECT_NEAR(geometry::length(centre(arc)), 16, 1e-9);
  EXPECT_NEAR(radius(edge_of(*edited, 2)), 20, 1e-9);
}

TEST(Fillet, ChangesNothingWhereEdgesGoOnSmoothly) { EXPECT_EQ(fillet(slot(), 1, 3), slot()); }

TEST(TouchingArc, LiesBetweenALineAndACircleThatDoNotMeet) {
  const Edge line{{0, 0}, {30, 0}};
  const Edge lower_half{{15, 20}, {45, 20}, 1};
  const auto arc = touching_arc(line, lower_half, 5, {15, 5});
  ASSERT_TRUE(arc);
  expect_point(centre(*arc), {16.771243, 5});
  expect_point(arc->from, {16.771243, 0});
  expect_point(arc->to, {20.078433, 8.75});
}

TEST(Join, ExtendsBothToTheirMeetingPoint) {
  const auto joined = join({{0, 0}, {30, 0}}, {{40, 10}, {40, 50}});
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->first, (Edge{{0, 0}, {40, 0}}));
  EXPECT_EQ(joined->second, (Edge{{40, 0}, {40, 50}}));
}

TEST(Join, TrimsAnArcAtItsNearerMeetingPoint) {
  const auto joined = join({{-20, 8}, {4, 8}}, {{0, -10}, {0, 10}, 1});
  ASSERT_TRUE(joined);
  expect_point(joined->first.to, {6, 8});
  EXPECT_NEAR(radius(joined->second), 10, 1e-9);
  expect_point(joined->second.to, {0, 10});
}

TEST(Join, IsNothingForParallelLinesAndConcentricArcs) {
  EXPECT_FALSE(join({{0, 0}, {30, 0}}, {{40, 10}, {80, 10}}));
  EXPECT_FALSE(join({{-5, 0}, {5, 0}, 1}, {{-8, 0}, {8, 0}, 1}));
}

}  // namespace
}  // namespace kerf::contour
