#include "geometry/angled_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/angle.hpp"
#include "seeded_random.hpp"

namespace kerf::geometry {
namespace {

using test::kSeed;
using test::SeededRandom;

constexpr double kAccuracy = 1e-9;       // of the size of the drawing
constexpr double kLeastTurn_rad = 0.01;  // between lines that are to cross

double angle_of(Vec2 from, Vec2 to) { return degrees(std::atan2(to.v - from.v, to.u - from.u)); }

double turn_between(Vec2 a, Vec2 b) { return std::fabs(cross(unit(a), unit(b))); }

void expect_near(std::optional<Vec2> found, Vec2 wanted, double size) {
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->u, wanted.u, kAccuracy * size);
  EXPECT_NEAR(found->v, wanted.v, kAccuracy * size);
}

// Points of a drawing of `size`, no two neighbouring lines nearly parallel, none nearly along an
// axis.
std::vector<Vec2> polyline(SeededRandom& random, double size, int count) {
  std::vector<Vec2> points{{random.in(-size, size), random.in(-size, size)}};
  while (static_cast<int>(points.size()) < count) {
    const Vec2 next{random.in(-size, size), random.in(-size, size)};
    const Vec2 way = next - points.back();
    if (length(way) < kLeastTurn_rad * size) continue;
    const Vec2 d = unit(way);
    if (std::min(std::fabs(d.u), std::fabs(d.v)) < kLeastTurn_rad) continue;
    const std::size_t last = points.size() - 1;
    if (last > 0 && turn_between(points[last] - points[last - 1], way) < kLeastTurn_rad) continue;
    points.push_back(next);
  }
  return points;
}

TEST(AngledLine, AnyPolylineByAnglesAndOneCoordinateHasTheSamePoints) {
  SeededRandom random(kSeed);
  for (int round = 0; round < 2000; ++round) {
    const double size = random.size(0.01, 1e5);
    const std::vector<Vec2> points = polyline(random, size, 8);
    Vec2 at = points.front();
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double turned = random.coin() ? 180 : 0;
      const AngledLine line{at, angle_of(points[i - 1], points[i]) + turned};
      const auto found =
          random.coin() ? point_at_u(line, points[i].u) : point_at_v(line, points[i].v);
      expect_near(found, points[i], size);
      at = points[i];
    }
  }
}

TEST(AngledLine, AnyTriangleByTwoAnglesAndItsEndHasTheSameCorner) {
  SeededRandom random(kSeed + 1);
  for (int round = 0; round < 20000; ++round) {
    const double size = random.size(0.01, 1e5);
    const std::vector<Vec2> p = polyline(random, size, 3);
    const double turned = random.coin() ? 180 : 0;
    expect_near(crossing({p[0], angle_of(p[0], p[1]) + turned}, {p[2], angle_of(p[1], p[2])}), p[1],
                size);
  }
}

TEST(AngledLine, TwoLinesCrossInThePointThatLiesOnBoth) {
  SeededRandom random(kSeed + 2);
  for (int round = 0; round < 5000; ++round) {
    const AngledLine a{{random.in(-50, 50), random.in(-50, 50)}, random.in(0, 360)};
    const AngledLine b{{random.in(-50, 50), random.in(-50, 50)}, a.angle_deg + random.in(1, 179)};
    const auto found = crossing(a, b);
    ASSERT_TRUE(found.has_value());
    const double size = 100 + length(*found);
    EXPECT_LT(distance(a, *found), kAccuracy * size);
    EXPECT_LT(distance(b, *found), kAccuracy * size);
  }
}

TEST(AngledLine, KeepsACoordinateAlongAnAxis) {
  EXPECT_EQ(crossing({{1.1, 2.3}, 180}, {{7.7, 9.9}, 90})->v, 2.3);
  EXPECT_EQ(point_at_u({{1.1, 2.3}, 0}, -40), (Vec2{-40, 2.3}));
  EXPECT_EQ(point_at_v({{1.1, 2.3}, 270}, -40), (Vec2{1.1, -40}));
}

TEST(AngledLine, ParallelLinesHaveNoCommonPoint) {
  SeededRandom random(kSeed + 3);
  for (int round = 0; round < 1000; ++round) {
    const double angle = random.in(0, 360);
    const double turned = 180.0 * random.count(-2, 2);
    EXPECT_FALSE(crossing({{1, 2}, angle}, {{30, -4}, angle + turned}).has_value());
  }
  EXPECT_FALSE(point_at_u({{1, 2}, 90}, 5).has_value());
  EXPECT_FALSE(point_at_v({{1, 2}, 180}, 5).has_value());
}

TEST(AngledLine, TheLeastAngleOfAProgramStillCrosses) {
  EXPECT_TRUE(crossing({{0, 0}, 0}, {{10, 1}, 0.001}).has_value());
  EXPECT_TRUE(point_at_v({{0, 0}, 180.001}, 1).has_value());
}

}  // namespace
}  // namespace kerf::geometry
