#include "output/picture/internal/arc_path.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plot_motions.hpp"

namespace kerf::output::plot {
namespace {

using motion::Direction;
using motion::Plane;

motion::Arc arc(Plane plane, Direction direction, std::uint16_t turns = 0) {
  motion::Arc result;
  result.plane = plane;
  result.direction = direction;
  result.turns = turns;
  return result;
}

void expect_near(const Point3& a, const Point3& b, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "coordinate " << i;
}

Point3 on_bezier(const Point3& from, const Bezier& curve, double t) {
  Point3 point;
  const double u = 1 - t;
  for (std::size_t i = 0; i < 3; ++i) {
    point[i] = u * u * u * from[i] + 3 * u * u * t * curve.control1[i] +
               3 * u * t * t * curve.control2[i] + t * t * t * curve.to[i];
  }
  return point;
}

TEST(ArcPath, ExtentsOfAHalfCircleReachItsTop) {
  const ArcPath half({10, 0, 0}, arc(Plane::xy, Direction::counterclockwise), {-10, 0, 0}, {0, 0});
  Box3 box;
  half.extend(box);
  expect_near(box.low(), {-10, 0, 0}, 1e-12);
  expect_near(box.high(), {10, 10, 0}, 1e-12);
}

TEST(ArcPath, ClockwiseTakesTheOtherWay) {
  const ArcPath half({10, 0, 0}, arc(Plane::xy, Direction::clockwise), {-10, 0, 0}, {0, 0});
  Box3 box;
  half.extend(box);
  expect_near(box.low(), {-10, -10, 0}, 1e-12);
  expect_near(box.high(), {10, 0, 0}, 1e-12);
}

TEST(ArcPath, AnEndEqualToTheStartIsAFullCircle) {
  const ArcPath circle({3, 4, 1}, arc(Plane::xy, Direction::clockwise), {3, 4, 1}, {0, 0});
  Box3 box;
  circle.extend(box);
  expect_near(box.low(), {-5, -5, 1}, 1e-12);
  expect_near(box.high(), {5, 5, 1}, 1e-12);
  expect_near(circle.at(0.5), {-3, -4, 1}, 1e-12);
}

TEST(ArcPath, CounterclockwiseInZxGoesFromZToX) {
  const ArcPath quarter({0, 7, 10}, arc(Plane::zx, Direction::counterclockwise), {10, 7, 0},
                        {0, 0});
  expect_near(quarter.at(0.5), {std::sqrt(50), 7, std::sqrt(50)}, 1e-12);
}

TEST(ArcPath, CounterclockwiseInYzGoesFromYToZ) {
  const ArcPath quarter({7, 10, 0}, arc(Plane::yz, Direction::counterclockwise), {7, 0, 10},
                        {0, 0});
  expect_near(quarter.at(0.5), {7, std::sqrt(50), std::sqrt(50)}, 1e-12);
}

TEST(ArcPath, AHelixRisesWithItsAngle) {
  const ArcPath helix({10, 0, 0}, arc(Plane::xy, Direction::counterclockwise, 2), {10, 0, -9},
                      {0, 0});
  EXPECT_EQ(helix.span_count(), 12U);
  expect_near(helix.at(1.0 / 3), {10, 0, -3}, 1e-12);
  expect_near(helix.at(0.5), {-10, 0, -4.5}, 1e-12);
}

TEST(ArcPath, OfVeryManyTurnsSomeAreDrawn) {
  const ArcPath helix({10, 0, 0}, arc(Plane::xy, Direction::counterclockwise, 65535), {10, 0, -9},
                      {0, 0});
  EXPECT_EQ(helix.span_count(), 4U * (ArcPath::kMaxTurns + 1));
  EXPECT_EQ(helix.at(1), (Point3{10, 0, -9}));
}

TEST(ArcPath, ExtentsHoldEveryPointOfRandomArcs) {
  testing::Random random(11);
  const auto number = [&] { return 20 * random.next() - 10; };
  for (int i = 0; i < 300; ++i) {
    const double cx = number(), cy = number(), radius = 5 * random.next(), a = number();
    const double b = number();
    const Point3 from{cx + radius * std::cos(a), cy + radius * std::sin(a), number()};
    const Point3 to{cx + radius * std::cos(b), cy + radius * std::sin(b), number()};
    const auto direction = i % 2 == 0 ? Direction::clockwise : Direction::counterclockwise;
    const ArcPath path(from, arc(Plane::xy, direction, i % 3 == 0 ? 2 : 0), to, {cx, cy});
    Box3 box, points;
    path.extend(box);
    for (int k = 0; k <= 3000; ++k) points.add(path.at(k / 3000.0));
    expect_near(box.low(), points.low(), 1e-3);
    expect_near(box.high(), points.high(), 1e-3);
  }
}

TEST(ArcPath, BezierCurvesFollowTheArcToThreeTenThousandthsOfTheRadius) {
  const ArcPath helix({100, 0, 0}, arc(Plane::xy, Direction::counterclockwise), {0, -100, -30},
                      {0, 0});
  Point3 from = helix.from();
  for (std::size_t i = 0; i < helix.span_count(); ++i) {
    const Bezier curve = helix.span(i);
    for (int k = 0; k <= 20; ++k) {
      const Point3 point = on_bezier(from, curve, k / 20.0);
      EXPECT_NEAR(std::hypot(point[kX], point[kY]), 100, 0.03);
    }
    from = curve.to;
  }
  EXPECT_EQ(from, (Point3{0, -100, -30}));
}

TEST(ArcPath, ChordsStayWithinTheTolerance) {
  const ArcPath circle({50, 0, 0}, arc(Plane::xy, Direction::clockwise), {50, 0, 0}, {0, 0});
  for (const double tolerance : {1.0, 0.1, 0.01, 0.001}) {
    const auto count = static_cast<double>(circle.chord_count(tolerance));
    const Point3 a = circle.at(0), b = circle.at(1 / count);
    const double middle = std::hypot((a[kX] + b[kX]) / 2, (a[kY] + b[kY]) / 2);
    EXPECT_LE(50 - middle, tolerance);
  }
}

}  // namespace
}  // namespace kerf::output::plot
