#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "motion/move_curves.hpp"
#include "motion_axes.hpp"
#include "planner/interpolator.hpp"
#include "planner/path_sampler.hpp"
#include "seeded_random.hpp"

namespace kerf::planner {
namespace {

using base::TipPoint;
using motion::Arc;
using motion::Line;
using motion::Motion;
using motion::Rapid;
using motion::Setpoint;
using motion::Spindle;
using motion::Thread;
using test::kSeed;
using test::SeededRandom;
using Actions = std::vector<Motion::Action>;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kPeriod_s = 0.001;
constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 1;

// Of a lathe: X as radius, and Z.
AxisLimits lathe_limits(double jerk = kInfinite) {
  AxisLimits limits = test::equal_limits(1, 1, jerk);
  limits.velocity.values[kX] = 20'000.0 / 60;
  limits.velocity.values[kZ] = 24'000.0 / 60;
  limits.acceleration.values[kX] = 3000;
  limits.acceleration.values[kZ] = 4000;
  return limits;
}

TipPoint place(double diameter, double z) { return {{diameter / 2, z}}; }

motion::AxisSetup lathe_at(const TipPoint& start) {
  motion::AxisSetup axes = test::axes_named("XZ", 20'000);
  axes.start = start;
  return axes;
}

Spindle surface(double metres_per_minute, double max_rpm) {
  return {.turning = Spindle::Turning::clockwise,
          .mode = Spindle::Mode::constant_surface_speed,
          .speed = metres_per_minute,
          .max_rpm = max_rpm,
          .radius_axis = base::Axis{kX}};
}

Spindle turning(double rpm) { return {.turning = Spindle::Turning::clockwise, .speed = rpm}; }

motion::Feed per_turn(double mm) { return {mm, motion::FeedMode::per_revolution}; }

double time_of(const TipPoint& start, const Actions& actions, const AxisLimits& limits,
               const Settings& settings = {.period_s = kPeriod_s}) {
  Interpolator interpolator(lathe_at(start), limits, settings);
  test::pass_over(interpolator, test::motions_of(actions));
  return interpolator.time_s();
}

std::vector<Setpoint> points_of(const TipPoint& start, const Actions& actions,
                                const AxisLimits& limits = lathe_limits(),
                                const Settings& settings = {.period_s = kPeriod_s}) {
  Interpolator interpolator(lathe_at(start), limits, settings);
  return test::points_of(interpolator, test::motions_of(actions));
}

// ∫ ds / v over the programmed curves, by trapezoids.
double trapezoids(const TipPoint& start, const Actions& actions, double s, double clamp) {
  constexpr int kCount = 4000;
  const motion::AxisSetup axes = lathe_at(start);
  motion::MoveCurves curves(axes);
  TipPoint at = start;
  double sum = 0;
  for (const Motion& motion : test::motions_of(actions)) {
    if (!motion::is_cut(motion)) continue;
    const auto* const line = std::get_if<Line>(&motion.action);
    const auto* const arc = std::get_if<Arc>(&motion.action);
    const double feed = line != nullptr ? line->feed.value : arc->feed.value;
    for (const motion::Curve& curve : curves.of(at, motion)) {
      for (int i = 0; i <= kCount; ++i) {
        const double diameter = 2 * std::fabs(curve.at(curve.length() * i / kCount).values[kX]);
        const double rpm = std::min(1000 * s / (std::numbers::pi * diameter), clamp);
        sum += curve.length() / kCount * (i == 0 || i == kCount ? 0.5 : 1) * 60 / (feed * rpm);
      }
      at = curve.end();
    }
  }
  return sum;
}

// Constant surface speed

struct Turned {
  double from_diameter, from_z, to_diameter, to_z, clamp, s, feed, seconds;
};

TEST(ConstantSurfaceSpeed, TakesTheTimesOfTheFormula) {
  for (const Turned& row :
       {Turned{50, 0, 0, 0, 3000, 200, 0.2, 3.4758}, Turned{120, 0, 0, 0, 3000, 200, 0.05, 69.9805},
        Turned{80, 0, -1.6, 0, 2500, 180, 0.15, 12.2148},
        Turned{20, 0, 60, -30, 4000, 150, 0.25, 7.2494},
        Turned{40, 0, 100, -80, 4000, 150, 0.1, 75.1570},
        Turned{75, 2, 75, -78, 3500, 140, 0.12, 67.3198}}) {
    const TipPoint from = place(row.from_diameter, row.from_z);
    const Actions actions{surface(row.s, row.clamp),
                          Line{place(row.to_diameter, row.to_z), per_turn(row.feed)}};
    for (const double jerk : {kInfinite, 1e5}) {
      const double time_s = time_of(from, actions, lathe_limits(jerk));
      RecordProperty("seconds", std::to_string(time_s));
      // Ramps at both ends take some ms.
      EXPECT_NEAR(time_s, row.seconds, 0.001 * row.seconds + 0.015) << row.seconds;
      EXPECT_GT(time_s, row.seconds * 0.9999);
    }
  }
}

Actions random_turning(SeededRandom& random, const TipPoint& start, double s, double clamp) {
  Actions actions{surface(s, clamp)};
  TipPoint at = start;
  for (int n = random.count(1, 12); n > 0; --n) {
    const TipPoint to = place(random.in(-20, 120), at.values[kZ] + random.in(-20, 5));
    const motion::Feed feed = per_turn(random.size(0.05, 0.5));
    if (random.coin()) {
      actions.push_back(Line{to, feed});
    } else {
      const double bulge = random.in(0.3, 2);
      const double x =
          (at.values[kX] + to.values[kX]) / 2 + bulge * (to.values[kZ] - at.values[kZ]);
      const double z =
          (at.values[kZ] + to.values[kZ]) / 2 - bulge * (to.values[kX] - at.values[kX]);
      actions.push_back(Arc{.to = to, .center = {z, x}, .feed = feed, .plane = motion::Plane::zx});
    }
    at = to;
  }
  return actions;
}

// But for the ramps at its ends: corners are rounded, with a tolerance that they can have at speed.
TEST(ConstantSurfaceSpeed, TakesTheTimeOfTheIntegralOnRandomContours) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 150; ++i) {
    const TipPoint start = place(random.in(0, 120), 0);
    const double s = random.size(20, 400);
    const double clamp = random.size(300, 5000);
    const Actions actions = random_turning(random, start, s, clamp);
    const double wanted = trapezoids(start, actions, s, clamp);
    AxisLimits limits = lathe_limits(random.coin() ? 1e6 : kInfinite);
    for (double& a : limits.acceleration.values) a = 30'000;
    const double time_s = time_of(start, actions, limits, {.period_s = 1e-4});
    const double ramps_s = 0.004 * static_cast<double>(actions.size());
    ASSERT_NEAR(time_s, wanted, 0.002 * wanted + ramps_s) << i;
  }
}

void expect_within_limits(const std::vector<Setpoint>& points, const AxisLimits& limits, int run) {
  for (std::size_t n = 2; n < points.size(); ++n) {
    for (std::size_t m = 0; m < 2; ++m) {
      const double a = points[n - 2].tip.values[m];
      const double b = points[n - 1].tip.values[m];
      const double c = points[n].tip.values[m];
      ASSERT_LE(std::fabs(c - b) / kPeriod_s, limits.velocity.values[m] * (1 + 1e-9) + 1e-9) << run;
      ASSERT_LE(std::fabs(c - 2 * b + a) / (kPeriod_s * kPeriod_s),
                limits.acceleration.values[m] * (1 + 1e-6) + 1e-6)
          << run << " at " << points[n].time_s;
    }
  }
}

// Also near the centre without a clamp, where the spindle could be as fast as it likes.
TEST(ConstantSurfaceSpeed, KeepsTheLimitsOfTheAxes) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 60; ++i) {
    const TipPoint start = place(random.in(0, 100), 0);
    const double clamp = random.coin() ? random.size(300, 20'000) : 0;
    const Actions actions = random_turning(random, start, random.size(50, 500), clamp);
    AxisLimits limits = lathe_limits(random.coin() ? random.size(1e3, 1e6) : kInfinite);
    for (double& a : limits.acceleration.values) a = random.size(50, 5000);
    for (double& v : limits.velocity.values) v = random.size(5, 500);
    expect_within_limits(points_of(start, actions, limits), limits, i);
  }
}

TEST(ConstantSurfaceSpeed, IsFollowedAlongASmoothedChain) {
  constexpr int kLines = 300;
  Actions actions{surface(150, 3000)};
  for (int i = 1; i <= kLines; ++i) {
    const double angle = std::numbers::pi / 2 * i / kLines;
    actions.push_back(Line{{{20 - 15 * std::cos(angle), -15 * std::sin(angle)}}, per_turn(0.1)});
  }
  const TipPoint start{{5, 0}};
  const double wanted = trapezoids(start, actions, 150, 3000);
  EXPECT_NEAR(time_of(start, actions, lathe_limits()), wanted, 0.002 * wanted);
}

TEST(ConstantSurfaceSpeed, HasNoStopWhereMoreIsAheadThanFitsIntoAPlan) {
  Actions actions{surface(200, 0)};
  constexpr int kMoves = 400;
  for (int i = 0; i < kMoves; ++i)
    actions.push_back(Line{{{i % 2 == 0 ? 60.0 : 1.0, -0.01 * i}}, per_turn(0.4)});
  const TipPoint start{{1, 0}};
  const double wanted = trapezoids(start, actions, 200, kInfinite);
  const double time_s = time_of(start, actions, lathe_limits());
  EXPECT_NEAR(time_s, wanted, 0.005 * wanted);
  EXPECT_EQ(points_of(start, actions).back().time_s, time_s);
}

TEST(ConstantSurfaceSpeed, HasTheOperatorsOverride) {
  const Actions actions{surface(200, 3000), Line{place(0, 0), per_turn(0.2)}};
  Interpolator interpolator(lathe_at(place(50, 0)), lathe_limits(), {.period_s = kPeriod_s});
  interpolator.set_overrides({.feed = 0.5});
  (void)test::points_of(interpolator, test::motions_of(actions));
  EXPECT_NEAR(interpolator.time_s(), 2 * 3.4758, 0.007);
}

// The override is changed on the way, so cells that are there get other limits.
TEST(ConstantSurfaceSpeed, HasAnOverrideThatChangesOnTheWay) {
  Interpolator interpolator(lathe_at(place(75, 0)), lathe_limits(), {.period_s = kPeriod_s});
  for (const Motion& motion :
       test::motions_of({surface(140, 3500), Line{place(60, -78), per_turn(0.12)}}))
    interpolator.take(motion);
  interpolator.finish();
  Setpoint point;
  while (interpolator.time_s() < 30 && interpolator.next(point)) continue;
  const double before_s = interpolator.time_s();
  const double whole_s =
      motion::PathSpeed::surface(surface(140, 3500), 0.12)
          .seconds(motion::Curve::line(place(75, 0), place(60, -78), std::hypot(7.5, 78), 2), 0,
                   std::hypot(7.5, 78));
  interpolator.set_overrides({.feed = 2});
  while (interpolator.next(point)) continue;
  EXPECT_NEAR(interpolator.time_s(), before_s + (whole_s - before_s) / 2, 0.02);
}

TEST(ConstantSurfaceSpeed, OfASpindleThatStandsNeitherDividesByZeroNorHangs) {
  for (Spindle spindle : {surface(0, 3000), surface(0, 0), turning(0)}) {
    spindle.turning = Spindle::Turning::stopped;
    const Actions actions{spindle, Line{place(0, 0), per_turn(0.2)}};
    const double time_s = time_of(place(50, 0), actions, lathe_limits());
    EXPECT_GT(time_s, 0.1);
    EXPECT_LT(time_s, 3);
  }
}

TEST(ConstantSurfaceSpeed, CountsPerRevolutionAtTheSpeedOfASpindleThatStands) {
  Spindle spindle = surface(200, 3000);
  spindle.turning = Spindle::Turning::stopped;
  const Actions actions{spindle, Line{place(0, 0), per_turn(0.2)}};
  EXPECT_NEAR(time_of(place(50, 0), actions, lathe_limits()), 3.4758, 0.005);
}

TEST(ConstantSurfaceSpeed, TakesItsTimeAlsoInEqualSteps) {
  const Actions actions{surface(200, 3000), Line{place(0, 0), per_turn(0.2)}};
  Settings settings{.period_s = kPeriod_s};
  settings.sampling = Sampling::equal_steps;
  PathSampler sampler(lathe_at(place(50, 0)), settings);
  test::pass_over(sampler, test::motions_of(actions));
  EXPECT_NEAR(sampler.time_s(), 3.4758, 1e-4);
}

// Threads

double cut_begin_s(const std::vector<Setpoint>& points, const TipPoint& start) {
  for (const Setpoint& point : points) {
    if (point.tip != start) return point.time_s;
  }
  return kInfinite;
}

// Z - lead θ, with θ from when the spindle was commanded at time 0.
void expect_thread(const std::vector<Setpoint>& points, double lead, double rpm, double from_z,
                   double to_z) {
  double first = kInfinite;
  for (const Setpoint& point : points) {
    const double z = point.tip.values[kZ];
    if (z > from_z || z < to_z) continue;
    const double off = z + lead * point.time_s * rpm / 60;
    if (first == kInfinite) first = off;
    ASSERT_NEAR(off, first, 0.001) << point.time_s;
  }
}

TEST(ThreadOfThePlanner, IsWhereTheSpindleIs) {
  const Actions actions{turning(200), Thread{place(30, -110), 1.5}};
  const auto points = points_of(place(30, 0), actions);
  expect_thread(points, 1.5, 200, -0.1, -109.9);
  EXPECT_NEAR(points.back().time_s, 22, 0.005);  // it begins at the mark
}

TEST(ThreadOfThePlanner, InFourBlocksIsOne) {
  Actions actions{turning(60)};
  for (const double z : {-13, -26, -39, -52}) actions.push_back(Thread{place(30, z), 2});
  for (const double tolerance : {0.0, 0.01}) {
    const auto points = points_of(place(30, 0), actions, lathe_limits(),
                                  {.period_s = kPeriod_s, .tolerance_mm = tolerance});
    expect_thread(points, 2, 60, -0.1, -51.9);
    EXPECT_NEAR(points.back().time_s, 26, 0.005);
  }
}

TEST(ThreadOfThePlanner, GoesOnAlongACone) {
  const Actions actions{turning(500), Thread{place(30, -20), 2}, Thread{place(34, -40), 2}};
  expect_thread(points_of(place(30, 0), actions), 2, 500, -0.5, -39.5);
}

TEST(ThreadOfThePlanner, WaitsForTheMark) {
  const Actions before{turning(90), Line{place(30, 5.3), {1000}}};
  Actions actions = before;
  actions.push_back(Thread{place(30, -20), 2});
  const double ready_s = time_of(place(30, 10), before, lathe_limits());
  const auto points = points_of(place(30, 10), actions);
  const double turn_s = 60.0 / 90;
  const double mark_s = std::ceil(ready_s / turn_s) * turn_s;
  const auto begins = std::find_if(points.begin(), points.end(),
                                   [&](const Setpoint& p) { return p.time_s > mark_s; });
  EXPECT_EQ((begins - 1)->tip, place(30, 5.3));
  EXPECT_LT(begins->tip.values[kZ], 5.3);
  const double length_s = 25.3 / (2 * 90.0 / 60);
  EXPECT_NEAR(points.back().time_s, mark_s + length_s, 0.003);
  EXPECT_EQ(time_of(place(30, 10), actions, lathe_limits()), points.back().time_s);
}

TEST(ThreadOfThePlanner, BeginsAtItsAngle) {
  for (const double degrees : {0.0, 90.0, 180.0, 270.0}) {
    const Actions actions{turning(60),
                          Thread{.to = place(30, -20), .lead = 2, .angle_deg = degrees}};
    EXPECT_NEAR(time_of(place(30, 0), actions, lathe_limits()), 10 + degrees / 360, 0.003);
  }
}

// Passes of one thread lie in one groove: at the same angle they are at the same Z.
TEST(ThreadOfThePlanner, IsInTheGrooveOfThePassBefore) {
  Actions actions{turning(733)};
  for (int pass = 0; pass < 6; ++pass) {
    actions.push_back(Rapid{place(30 - 0.3 * pass, 3)});
    actions.push_back(Thread{place(30 - 0.3 * pass, -20), 1.5});
    actions.push_back(Rapid{place(40, -20)});
    actions.push_back(Rapid{place(40, 3 + 0.77 * pass)});
  }
  double phase = kInfinite;
  for (const Setpoint& point : points_of(place(40, 3), actions)) {
    const double z = point.tip.values[kZ];
    if (point.mark.block.line % 4 != 3 || z > 2 || z < -19) continue;
    const double turns = (z / 1.5 + point.time_s * 733 / 60);
    const double here = turns - std::floor(turns);
    if (phase == kInfinite) phase = here;
    const double off = here - phase;
    ASSERT_NEAR((off - std::round(off)) * 1.5, 0, 0.001) << point.time_s;
  }
  EXPECT_NE(phase, kInfinite);
}

TEST(ThreadOfThePlanner, KeepsTheSpeedThatSurfaceSpeedHasAtItsBegin) {
  const Actions actions{surface(100, 3000), Thread{place(30, -20), 1.5},
                        Thread{place(60, -50), 1.5}};
  const double rpm = 100'000 / (std::numbers::pi * 30);
  const auto points = points_of(place(30, 0), actions);
  const double time_s = points.back().time_s - cut_begin_s(points, place(30, 0));
  const double ramps_s = 1.5 * rpm / 60 / 4000;
  EXPECT_NEAR(time_s, 50 / (1.5 * rpm / 60) + ramps_s, 0.002);
}

TEST(ThreadOfThePlanner, HasALeadThatGrows) {
  const Thread thread{.to = place(30, -60), .lead = 1, .lead_change = 0.25};
  const double rpm = 300;
  const auto points = points_of(place(30, 0), {turning(rpm), thread});
  double off = kInfinite;
  for (const Setpoint& point : points) {
    const double z = -point.tip.values[kZ];
    if (z < 1 || z > 59) continue;
    // θ of z = θ + K θ²/2, without a difference of near numbers.
    const double turns = 2 * z / (1 + std::sqrt(1 + 2 * 0.25 * z));
    const double late = point.time_s * rpm / 60 - turns;
    if (off == kInfinite) off = late;
    ASSERT_NEAR(late, off, 0.0015) << z;  // of a turn
  }
  const double turns = 2 * 60 / (1 + std::sqrt(1 + 2 * 0.25 * 60));
  EXPECT_NEAR(points.back().time_s, turns * 60 / rpm, 0.01);
}

TEST(ThreadOfThePlanner, IsNotHeldNorOverridden) {
  Interpolator interpolator(lathe_at(place(30, 0)), lathe_limits(), {.period_s = kPeriod_s});
  for (const Motion& motion :
       test::motions_of({turning(200), Thread{place(30, -15), 1.5}, Rapid{place(40, -15)}}))
    interpolator.take(motion);
  interpolator.finish();
  Setpoint point;
  std::vector<Setpoint> points;
  while (!interpolator.held() && interpolator.next(point)) {
    points.push_back(point);
    if (points.size() == 500) interpolator.set_overrides({.feed = 0.3});
    if (points.size() == 1000) interpolator.hold();
    ASSERT_LT(points.size(), 5000U);
  }
  ASSERT_TRUE(interpolator.held());
  EXPECT_EQ(interpolator.tip(), place(30, -15));
  EXPECT_NEAR(interpolator.time_s(), 3, 0.005);
  expect_thread(points, 1.5, 200, -0.1, -14.9);
}

TEST(ThreadOfThePlanner, IsBrokenOffByReset) {
  Interpolator interpolator(lathe_at(place(30, 0)), lathe_limits(), {.period_s = kPeriod_s});
  for (const Motion& motion : test::motions_of({turning(200), Thread{place(30, -15), 1.5}}))
    interpolator.take(motion);
  interpolator.finish();
  Setpoint point;
  while (interpolator.time_s() < 1 && interpolator.next(point)) continue;
  interpolator.reset();
  while (!interpolator.at_reset() && interpolator.next(point)) continue;
  EXPECT_LT(interpolator.time_s(), 1.1);
}

// While it waits for the mark it can be held; then it waits for a mark again.
TEST(ThreadOfThePlanner, WaitsAnewBehindAHoldInItsWait) {
  Interpolator interpolator(lathe_at(place(30, 0)), lathe_limits(), {.period_s = kPeriod_s});
  for (const Motion& motion :
       test::motions_of({turning(60), Thread{.to = place(30, -20), .lead = 2, .angle_deg = 180}}))
    interpolator.take(motion);
  interpolator.finish();
  Setpoint point;
  while (interpolator.time_s() < 0.1 && interpolator.next(point)) continue;
  interpolator.hold();
  while (interpolator.time_s() < 0.8 && interpolator.next(point)) continue;
  EXPECT_TRUE(interpolator.held());
  interpolator.resume();
  while (interpolator.next(point)) continue;
  EXPECT_NEAR(interpolator.time_s(), 11.5, 0.003);
}

TEST(ThreadOfThePlanner, OfASpindleThatStandsDoesNotHang) {
  EXPECT_LT(time_of(place(30, 0), {turning(0), Thread{place(30, -20), 2}}, lathe_limits()), 1);
}

}  // namespace
}  // namespace kerf::planner
