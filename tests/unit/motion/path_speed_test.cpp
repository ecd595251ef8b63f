#include "motion/path_speed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "motion/move_curves.hpp"
#include "motion/spindle_speed.hpp"
#include "motion/thread_speed.hpp"
#include "motion_axes.hpp"
#include "seeded_random.hpp"

namespace kerf::motion {
namespace {

using base::TipPoint;
using test::kSeed;
using test::SeededRandom;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kPi = std::numbers::pi;

Spindle surface(double metres_per_minute, double max_rpm, double centre = 0) {
  Spindle spindle;
  spindle.turning = Spindle::Turning::clockwise;
  spindle.mode = Spindle::Mode::constant_surface_speed;
  spindle.speed = metres_per_minute;
  spindle.max_rpm = max_rpm;
  spindle.radius_axis = base::Axis{0};
  spindle.centre = centre;
  return spindle;
}

// The formula as a machinist has it: n = 1000 S / (π D), at most the clamp.
double rpm_of(double diameter, double metres_per_minute, double clamp) {
  const double rpm = 1000 * metres_per_minute / (kPi * std::fabs(diameter));
  return clamp > 0 ? std::min(rpm, clamp) : rpm;
}

// ∫ ds / v by trapezoids.
double trapezoids(const Curve& curve, double from, double to, double centre, double clamp,
                  double metres_per_minute, double feed) {
  constexpr int kCount = 20'000;
  double sum = 0;
  for (int i = 0; i <= kCount; ++i) {
    const double s = from + (to - from) * i / kCount;
    const double diameter = 2 * (curve.at(s).values[0] - centre);
    const double seconds = 60 / (feed * rpm_of(diameter, metres_per_minute, clamp));
    sum += (i == 0 || i == kCount ? 0.5 : 1) * seconds;
  }
  return sum * (to - from) / kCount;
}

Curve curve_of(const TipPoint& from, const Motion::Action& action) {
  static const AxisSetup axes = test::axes_named("XZ");
  MoveCurves curves(axes);
  return curves.of(from, test::motions_of({action}).front()).front();
}

Curve random_curve(SeededRandom& random) {
  const TipPoint from{{random.in(-60, 60), random.in(-50, 50)}};
  const TipPoint to{{random.in(-60, 60), random.in(-50, 50)}};
  if (random.coin()) return curve_of(from, Line{to, {}});
  const double bulge = random.in(-2, 2);
  const double x = (from.values[0] + to.values[0]) / 2 + bulge * (to.values[1] - from.values[1]);
  const double z = (from.values[1] + to.values[1]) / 2 - bulge * (to.values[0] - from.values[0]);
  return curve_of(
      from, Arc{.to = to,
                .center = {z, x},
                .feed = {},
                .plane = Plane::zx,
                .direction = random.coin() ? Direction::clockwise : Direction::counterclockwise});
}

TEST(SpindleSpeed, FollowsTheRadiusUpToTheLimits) {
  struct Row {
    double diameter, free, clamped;
  };
  for (const Row& row :
       {Row{100, 636.62, 636.62}, Row{50, 1273.24, 1273.24}, Row{30, 2122.07, 2122.07},
        Row{25.4648, 2500.00, 2500.00}, Row{20, 3183.10, 2500.00}, Row{10, 6366.20, 2500.00},
        Row{1, 63661.98, 2500.00}}) {
    const TipPoint tip{{7 - row.diameter / 2, 3}};
    EXPECT_NEAR(rpm_at(surface(200, 0, 7), tip), row.free, 0.005) << row.diameter;
    EXPECT_NEAR(rpm_at(surface(200, 2500, 7), tip), row.clamped, 0.005) << row.diameter;
  }
  EXPECT_EQ(rpm_at(surface(200, 2500), {}), 2500);
  Spindle both = surface(200, 2500);
  both.most_rpm = 2000;
  EXPECT_EQ(rpm_at(both, {}), 2000);
  EXPECT_TRUE(std::isfinite(rpm_at(surface(200, 0), {})));
}

TEST(SpindleSpeed, IsTheLimitWhereTheRadiusIsNotKnown) {
  Spindle spindle = surface(200, 2500);
  spindle.radius_axis.reset();
  EXPECT_EQ(rpm_at(spindle, TipPoint{{20, 0}}), 2500);
  EXPECT_EQ(rpm_at(Spindle{.speed = 300}, TipPoint{{20, 0}}), 300);
}

TEST(PathSpeed, TakesAsLongAsTrapezoidsSay) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 300; ++i) {
    const Curve curve = random_curve(random);
    const double s = random.size(20, 500);
    const double clamp = random.coin() ? random.size(200, 6000) : 0;
    const double centre = random.in(-30, 30);
    const double feed = random.size(0.02, 1);
    const double a = random.in(0, curve.length());
    const double b = random.in(0, curve.length());
    const auto [from, to] = std::minmax(a, b);
    const PathSpeed speed = PathSpeed::surface(surface(s, clamp, centre), feed);
    const double wanted = trapezoids(curve, from, to, centre, clamp, s, feed);
    ASSERT_NEAR(speed.seconds(curve, from, to), wanted, 2e-4 * wanted + 1e-9) << i;
  }
}

TEST(PathSpeed, IsNearlyConstantInEachPart) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 300; ++i) {
    const Curve curve = random_curve(random);
    const PathSpeed speed =
        PathSpeed::surface(surface(random.size(20, 500), random.size(200, 6000)), 0.2);
    int parts = 0;
    double sum = 0;
    for (double from = 0; from < curve.length(); ++parts) {
      const double to = speed.part_end(curve, from, curve.length());
      ASSERT_GT(to, from);
      const double mean = speed.mean(curve, from, to);
      for (int k = 0; k <= 10; ++k) {
        const double here = speed.at(curve, from + (to - from) * k / 10);
        ASSERT_NEAR(here, mean, 1.01 * PathSpeed::kStep * mean) << i;
      }
      sum += (to - from) / mean;
      from = to;
    }
    ASSERT_NEAR(sum, speed.seconds(curve, 0, curve.length()), 1e-9 * sum) << i;
    ASSERT_LT(parts, 1500) << i;
  }
}

TEST(PathSpeed, OfALineAtOneRadiusIsOnePart) {
  const Curve curve = curve_of({{37.5, 2}}, Line{{{37.5, -78}}, {}});
  const PathSpeed speed = PathSpeed::surface(surface(140, 3500), 0.12);
  EXPECT_EQ(speed.part_end(curve, 0, curve.length()), curve.length());
  EXPECT_NEAR(speed.seconds(curve, 0, curve.length()), 67.3198, 5e-5);
}

TEST(PathSpeed, IsOfAnotherParameter) {
  const Curve curve = curve_of({{30, 0}}, Line{{{10, 0}}, {}});
  const PathSpeed speed = PathSpeed::surface(surface(140, 3500), 0.12);
  EXPECT_DOUBLE_EQ(speed.over(4).at(curve, 3), speed.at(curve, 3) / 4);
  EXPECT_DOUBLE_EQ(speed.times(4).at(curve, 3), speed.at(curve, 3) * 4);
  const PathSpeed growing = PathSpeed::growing(2, 3);
  EXPECT_DOUBLE_EQ(growing.over(4).at(curve, 0), growing.at(curve, 0) / 4);
  EXPECT_DOUBLE_EQ(growing.times(2).at(curve, 5), growing.at(curve, 5) * 2);
}

// Threads

TEST(ThreadWay, CountsItsLeadAlongTheLongerAxis) {
  const AxisSetup axes = test::axes_named("XZ");
  const TipPoint from{{5, 0}};
  const ThreadWay cone({.to = {{25, -10}}, .lead = 1.5}, from, axes);
  EXPECT_DOUBLE_EQ(cone.lead_way_mm(), 20);
  EXPECT_NEAR(cone.length_mm() / cone.speed(500).at({}, 0), 1.6, 1e-12);
  EXPECT_NEAR(cone.revolutions() * 60 / 500, 1.6, 1e-12);
  const ThreadWay straight({.to = {{5, -110}}, .lead = 1.5}, from, axes);
  EXPECT_NEAR(straight.revolutions() * 60 / 200, 22, 1e-12);
}

// z = L θ + K θ²/2 with θ = n t.
TEST(ThreadWay, WithAGrowingLeadTakesTheTimeOfItsTurns) {
  SeededRandom random(kSeed);
  const AxisSetup axes = test::axes_named("XZ");
  for (int i = 0; i < 200; ++i) {
    const double lead = random.size(0.2, 10);
    const double turns = random.in(1, 50);
    const double change = random.in(-0.9 * lead / turns, lead);
    const double rpm = random.size(20, 2000);
    const double z = turns * (lead + change * turns / 2);
    const TipPoint to{{z * random.in(-1, 1), random.coin() ? z : -z}};
    const ThreadWay way({.to = to, .lead = lead, .lead_change = change}, {}, axes);
    EXPECT_NEAR(way.revolutions(), turns, 1e-9 * turns) << i;
    const Curve curve = curve_of({}, Line{to, {}});
    const double wanted = turns * 60 / rpm;
    const PathSpeed speed = way.speed(rpm);
    EXPECT_NEAR(speed.seconds(curve, 0, curve.length()), wanted, 1e-9 * wanted) << i;
    double sum = 0;
    for (double from = 0; from < curve.length();) {
      const double end = speed.part_end(curve, from, curve.length());
      sum += (end - from) / speed.mean(curve, from, end);
      from = end;
    }
    EXPECT_NEAR(sum, wanted, 1e-9 * wanted) << i;
  }
}

TEST(ThreadWay, WhoseLeadShrinksToNothingHasAnEnd) {
  const AxisSetup axes = test::axes_named("XZ");
  const Thread thread{.to = {{0, -20}}, .lead = 1, .lead_change = -0.1};
  const ThreadWay way(thread, {}, axes);
  EXPECT_EQ(way.revolutions(), kInfinite);
  const Curve curve = curve_of({}, Line{thread.to, {}});
  EXPECT_TRUE(std::isfinite(way.speed(500).seconds(curve, 0, curve.length())));
}

TEST(HighestRpm, IsWhereAnAxisHasItsVelocity) {
  AxisSetup axes = test::axes_named("XZ");
  axes.axes[0].rapid_per_min = 6000;
  axes.axes[1].rapid_per_min = 9000;
  EXPECT_DOUBLE_EQ(highest_rpm({.to = {{0, -30}}, .lead = 3}, {}, axes), 3000);
  EXPECT_DOUBLE_EQ(highest_rpm({.to = {{-30, -30}}, .lead = 3}, {}, axes), 2000);
  // 3 mm more per turn: behind 4 turns, 36 mm, it has grown to 15.
  EXPECT_DOUBLE_EQ(highest_rpm({.to = {{0, -36}}, .lead = 3, .lead_change = 3}, {}, axes), 600);
  EXPECT_EQ(highest_rpm({.to = {}, .lead = 3}, {}, axes), kInfinite);
}

}  // namespace
}  // namespace kerf::motion
