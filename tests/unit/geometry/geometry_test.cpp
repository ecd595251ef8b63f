#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/arc.hpp"
#include "geometry/intersect.hpp"
#include "seeded_random.hpp"

namespace kerf::geometry {
namespace {

using test::kSeed;
using test::SeededRandom;

constexpr double kFull = 2 * std::numbers::pi;
constexpr int kCases = 100'000;
constexpr double kTolerance = 0.01;

Vec2 random_point(SeededRandom& random) { return {random.in(-100, 100), random.in(-100, 100)}; }

Vec2 turned(Vec2 arm, double angle_rad) {
  return {arm.u * std::cos(angle_rad) - arm.v * std::sin(angle_rad),
          arm.u * std::sin(angle_rad) + arm.v * std::cos(angle_rad)};
}

std::string text(Vec2 point) {
  return "(" + std::to_string(point.u) + ", " + std::to_string(point.v) + ")";
}

TEST(CentreFromRadius, LiesAtTheRadiusFromBothEnds) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const Vec2 from = random_point(random);
    const Vec2 to = random_point(random);
    const double r = length(to - from) / 2 * (1 + random.size(1e-6, 100));
    const double radius = random.coin() ? r : -r;
    const auto centre = centre_from_radius(from, to, radius, random.coin(), kTolerance);
    ASSERT_TRUE(centre) << text(from) << " to " << text(to) << " R" << radius;
    ASSERT_NEAR(length(from - *centre), r, 1e-9 * r) << text(from) << " " << text(to);
    ASSERT_NEAR(length(to - *centre), r, 1e-9 * r) << text(from) << " " << text(to);
  }
}

TEST(CentreFromRadius, ShortWayForPositiveAndLongWayForNegativeRadius) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const Vec2 from = random_point(random);
    const Vec2 to = random_point(random);
    const double r = length(to - from) / 2 * (1 + random.size(1e-3, 10));
    const bool clockwise = random.coin();
    const double short_way =
        sweep_rad(from, to, *centre_from_radius(from, to, r, clockwise, kTolerance), clockwise);
    const double long_way =
        sweep_rad(from, to, *centre_from_radius(from, to, -r, clockwise, kTolerance), clockwise);
    ASSERT_LT(short_way, std::numbers::pi) << text(from) << " to " << text(to) << " R" << r;
    ASSERT_GT(long_way, std::numbers::pi) << text(from) << " to " << text(to) << " R" << -r;
    ASSERT_NEAR(short_way + long_way, kFull, 1e-9);
  }
}

TEST(CentreFromRadius, IsThatOfTheSpecificationsExamples) {  // ARC-5
  const auto expect_centre = [](double radius, bool clockwise, Vec2 wanted) {
    const auto centre = centre_from_radius({0, 0}, {10, 10}, radius, clockwise, kTolerance);
    ASSERT_TRUE(centre);
    EXPECT_LT(length(*centre - wanted), 1e-12) << text(*centre) << ", wanted " << text(wanted);
  };
  expect_centre(10, true, {10, 0});
  expect_centre(10, false, {0, 10});
  expect_centre(-10, true, {0, 10});
}

TEST(CentreFromRadius, IsTheMidpointOfAChordThatIsTooLongWithinTheTolerance) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const Vec2 from = random_point(random);
    const Vec2 to = random_point(random);
    const double half = length(to - from) / 2;
    if (half < 1) continue;
    const double radius = (half - random.in(0, 0.999 * kTolerance)) * (random.coin() ? 1 : -1);
    const auto centre = centre_from_radius(from, to, radius, random.coin(), kTolerance);
    ASSERT_TRUE(centre) << text(from) << " to " << text(to) << " R" << radius;
    ASSERT_NEAR(length(*centre - 0.5 * (from + to)), 0, 1e-9);
    const double less = half - random.in(1.001 * kTolerance, half);
    ASSERT_FALSE(centre_from_radius(from, to, less, random.coin(), kTolerance))
        << text(from) << " to " << text(to) << " R" << less;
  }
}

TEST(Sweep, TurnsTheStartIntoTheEnd) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const Vec2 centre = random_point(random);
    const Vec2 from = centre + random.size(0.01, 100) * unit(random_point(random));
    const double angle = random.in(1e-6, kFull - 1e-6);
    const bool clockwise = random.coin();
    const Vec2 to = centre + turned(from - centre, clockwise ? -angle : angle);
    ASSERT_NEAR(sweep_rad(from, to, centre, clockwise), angle, 1e-9)
        << text(from) << " to " << text(to) << " about " << text(centre);
  }
}

TEST(Sweep, BothWaysTogetherAreAFullCircle) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const Vec2 centre = random_point(random);
    const Vec2 from = random_point(random);
    const Vec2 to = random_point(random);
    const double one = sweep_rad(from, to, centre, true);
    const double other = sweep_rad(from, to, centre, false);
    ASSERT_GT(one, 0);
    ASSERT_GT(other, 0);
    ASSERT_NEAR(one + other, kFull, 1e-12) << text(from) << " to " << text(to);
  }
}

TEST(Sweep, OfOnePointIsAFullCircle) {
  EXPECT_EQ(sweep_rad({3, 4}, {3, 4}, {0, 0}, true), kFull);
  EXPECT_EQ(sweep_rad({3, 4}, {3, 4}, {1, 1}, false), kFull);
}

TEST(ArcLength, IsThatOfManyShortChords) {
  SeededRandom random(kSeed);
  constexpr int kChords = 20'000;
  for (int i = 0; i < 20; ++i) {
    const Vec2 centre = random_point(random);
    const Vec2 from = centre + random.size(1, 50) * unit(random_point(random));
    const double angle = random.in(0.1, kFull - 0.1);
    const bool clockwise = random.coin();
    const unsigned turns = random.coin() ? 0 : 2;
    const double rise = random.in(-20, 20);
    const Vec2 to = centre + turned(from - centre, clockwise ? -angle : angle);
    const double whole = angle + kFull * turns;
    double sum = 0;
    for (int k = 0; k < kChords; ++k) {
      const double sign = clockwise ? -1 : 1;
      const Vec2 a = turned(from - centre, sign * whole * k / kChords);
      const Vec2 b = turned(from - centre, sign * whole * (k + 1) / kChords);
      sum += std::hypot(length(b - a), rise / kChords);
    }
    EXPECT_NEAR(arc_length(from, to, centre, clockwise, turns, rise), sum, 1e-6 * sum)
        << text(from) << " to " << text(to) << ", " << turns << " turns, rise " << rise;
  }
}

// How far a point lies from a curve.
double distance(const Curve& curve, Vec2 point) {
  if (curve.is_circle) return std::fabs(length(point - curve.point) - curve.radius);
  return std::fabs(cross(unit(curve.direction), point - curve.point));
}

// Signed side of a curve on which a point lies.
double side(const Curve& curve, Vec2 point) {
  if (curve.is_circle) return length(point - curve.point) - curve.radius;
  return cross(unit(curve.direction), point - curve.point);
}

Vec2 at(const Curve& curve, double parameter) {
  if (curve.is_circle) return curve.point + turned({curve.radius, 0}, parameter);
  return curve.point + parameter * unit(curve.direction);
}

// Crossings of `a` with `b`, found by walking along `a` and watching the side of `b`.
int crossings(const Curve& a, const Curve& b) {
  constexpr int kSteps = 4000;
  const double begin = a.is_circle ? 0 : -1000;
  const double end = a.is_circle ? kFull : 1000;
  int count = 0;
  bool positive = side(b, at(a, begin)) > 0;
  for (int i = 1; i <= kSteps; ++i) {
    const bool now = side(b, at(a, begin + (end - begin) * i / kSteps)) > 0;
    count += now != positive ? 1 : 0;
    positive = now;
  }
  return count;
}

Curve random_curve(SeededRandom& random) {
  if (random.coin()) return {true, random_point(random), {}, random.size(5, 100)};
  return {false, random_point(random), random_point(random), 0};
}

std::string text(const Curve& curve) {
  return curve.is_circle ? "circle about " + text(curve.point) + " R" + std::to_string(curve.radius)
                         : "line through " + text(curve.point) + " along " + text(curve.direction);
}

// Too near to touching for a walk in steps to tell.
bool nearly_touches(const Curve& a, const Curve& b) {
  if (!a.is_circle && !b.is_circle)
    return std::fabs(cross(unit(a.direction), unit(b.direction))) < 0.3;
  if (a.is_circle && b.is_circle) {
    const double d = length(a.point - b.point);
    return std::fabs(d - a.radius - b.radius) < 0.5 ||
           std::fabs(d - std::fabs(a.radius - b.radius)) < 0.5;
  }
  const Curve& line = a.is_circle ? b : a;
  const Curve& circle = a.is_circle ? a : b;
  return std::fabs(distance(line, circle.point) - circle.radius) < 0.5;
}

TEST(Intersect, FindsAsManyPointsAsAWalkAlongTheCurve) {
  SeededRandom random(kSeed);
  int tried = 0;
  for (int i = 0; tried < 2000; ++i) {
    const Curve a = random_curve(random);
    const Curve b = random_curve(random);
    if (nearly_touches(a, b)) continue;
    ++tried;
    ASSERT_EQ(intersect(a, b, 1e-7).count, static_cast<std::size_t>(crossings(a, b)))
        << text(a) << ", " << text(b) << " (case " << i << ", seed " << kSeed << ")";
  }
}

TEST(Intersect, EveryPointLiesOnBothCurves) {
  SeededRandom random(kSeed + 1);
  for (int i = 0; i < kCases; ++i) {
    const Curve a = random_curve(random);
    const Curve b = random_curve(random);
    if (!a.is_circle && !b.is_circle && nearly_touches(a, b)) continue;
    const Intersections found = intersect(a, b, 1e-7);
    for (std::size_t k = 0; k < found.count; ++k) {
      ASSERT_LT(distance(a, found.points[k]), 1e-6) << text(a) << ", " << text(b);
      ASSERT_LT(distance(b, found.points[k]), 1e-6) << text(a) << ", " << text(b);
    }
  }
}

TEST(Intersect, DoesNotDependOnTheOrderOfTheCurves) {
  SeededRandom random(kSeed + 2);
  for (int i = 0; i < kCases; ++i) {
    const Curve a = random_curve(random);
    const Curve b = random_curve(random);
    const Intersections one = intersect(a, b, 1e-7);
    const Intersections other = intersect(b, a, 1e-7);
    ASSERT_EQ(one.count, other.count) << text(a) << ", " << text(b);
    for (std::size_t k = 0; k < one.count; ++k) {
      double nearest = 1e9;
      for (std::size_t m = 0; m < other.count; ++m)
        nearest = std::min(nearest, length(one.points[k] - other.points[m]));
      if (!nearly_touches(a, b)) {
        ASSERT_LT(nearest, 1e-6) << text(a) << ", " << text(b);
      }
    }
  }
}

// The common point of curves that miss each other by `gap` lies in the middle of it.
void expect_touch(const Curve& a, const Curve& b, double gap) {
  const Intersections found = intersect(a, b, 1e-4);
  if (found.count != 1) return;
  EXPECT_LT(distance(a, found.points[0]), gap / 2 + 1e-9) << text(a) << ", " << text(b);
  EXPECT_LT(distance(b, found.points[0]), gap / 2 + 1e-9) << text(a) << ", " << text(b);
}

TEST(Intersect, CurvesThatMissEachOtherByNoMoreThanTheToleranceTouch) {
  constexpr double kMiss = 1e-4;
  SeededRandom random(kSeed + 3);
  for (int i = 0; i < kCases; ++i) {
    const Vec2 centre = random_point(random);
    const Vec2 direction = unit(random_point(random));
    const double r = random.size(0.1, 100);
    const double gap = random.in(0, 0.99 * kMiss);
    const Curve circle{true, centre, {}, r};
    const Curve line{false, centre + (r + gap) * left_of(direction), direction, 0};
    ASSERT_GE(intersect(circle, line, kMiss).count, 1U) << text(circle) << ", " << text(line);
    const double r2 = random.size(0.1, 100);
    const Curve outside{true, centre + (r + r2 + gap) * direction, {}, r2};
    ASSERT_GE(intersect(circle, outside, kMiss).count, 1U) << text(circle) << ", " << text(outside);
    expect_touch(circle, outside, gap);
    if (std::fabs(r - r2) < 10 * kMiss) continue;
    const Curve inside{
        true,
        centre + (std::fabs(r - r2) - std::min(gap, std::fabs(r - r2) / 2)) * direction,
        {},
        r2};
    ASSERT_GE(intersect(circle, inside, kMiss).count, 1U) << text(circle) << ", " << text(inside);
    expect_touch(circle, inside, gap);
    expect_touch(inside, circle, gap);
  }
}

TEST(Intersect, CurvesThatMissEachOtherByMuchMoreHaveNoCommonPoint) {
  constexpr double kMiss = 1e-4;
  SeededRandom random(kSeed + 4);
  for (int i = 0; i < kCases; ++i) {
    const Vec2 centre = random_point(random);
    const Vec2 direction = unit(random_point(random));
    const double r = random.size(0.1, 100);
    const double gap = random.in(3 * kMiss, 10);
    const Curve circle{true, centre, {}, r};
    const Curve line{false, centre + (r + gap) * left_of(direction), direction, 0};
    ASSERT_EQ(intersect(circle, line, kMiss).count, 0U) << text(circle) << ", " << text(line);
    const double r2 = random.size(0.1, 100);
    const Curve outside{true, centre + (r + r2 + gap) * direction, {}, r2};
    const Intersections found = intersect(circle, outside, kMiss);
    ASSERT_EQ(found.count, 0U) << text(circle) << ", " << text(outside) << ", which miss each other"
                               << " by " << gap << " mm";
  }
}

TEST(Intersect, ParallelLinesAndEqualCirclesHaveNone) {
  EXPECT_EQ(intersect({false, {0, 0}, {1, 2}, 0}, {false, {5, 0}, {2, 4}, 0}, 1e-7).count, 0U);
  EXPECT_EQ(intersect({false, {0, 0}, {1, 2}, 0}, {false, {0, 0}, {-1, -2}, 0}, 1e-7).count, 0U);
  EXPECT_EQ(intersect({true, {3, 4}, {}, 5}, {true, {3, 4}, {}, 5}, 1e-7).count, 0U);
  EXPECT_EQ(intersect({true, {3, 4}, {}, 5}, {true, {3, 4}, {}, 6}, 1e-7).count, 0U);
}

}  // namespace
}  // namespace kerf::geometry
