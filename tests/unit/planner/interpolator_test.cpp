#include "planner/interpolator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "allocation_count.hpp"
#include "motion_axes.hpp"
#include "seeded_random.hpp"

namespace kerf::planner {
namespace {

using base::TipPoint;
using motion::Arc;
using motion::Dwell;
using motion::Line;
using motion::Motion;
using motion::Rapid;
using test::axes_named;
using test::kSeed;
using test::SeededRandom;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::size_t kAxes = 3;

/// Along a straight line: the least that any axis allows.
struct LineLimits {
  double velocity, acceleration, jerk;
};

LineLimits along(const TipPoint& to, double length, double feed, const AxisLimits& limits) {
  LineLimits least{feed, kInfinite, kInfinite};
  for (std::size_t m = 0; m < kAxes; ++m) {
    const double share = std::fabs(to.values[m]) / length;
    least.velocity = std::min(least.velocity, limits.velocity.values[m] / share);
    least.acceleration = std::min(least.acceleration, limits.acceleration.values[m] / share);
    least.jerk = std::min(least.jerk, limits.jerk.values[m] / share);
  }
  return least;
}

// From rest to rest there is no faster way: constant jerk, acceleration or velocity throughout.
double least_time_s(double length, const LineLimits& limits) {
  const double v = limits.velocity;
  const double a = limits.acceleration;
  const double j = limits.jerk;
  if (!std::isfinite(j))
    return length >= v * v / a ? length / v + v / a : 2 * std::sqrt(length / a);
  if (v <= a * a / j) {
    const double rise = std::sqrt(v / j);
    return length >= 2 * v * rise ? length / v + 2 * rise : 4 * std::cbrt(length / (2 * j));
  }
  const double rise = a / j;
  if (length >= v * (v / a + rise)) return length / v + v / a + rise;
  if (length >= 2 * a * rise * rise) return rise + std::sqrt(rise * rise + 4 * length / a);
  return 4 * std::cbrt(length / (2 * j));
}

double length_of(const TipPoint& to) {
  return std::hypot(to.values[0], to.values[1], to.values[2]);
}

AxisLimits random_limits(SeededRandom& random) {
  AxisLimits limits = test::equal_limits(1, 1, 1);
  const bool jerk_limited = random.coin();
  for (std::size_t m = 0; m < kAxes; ++m) {
    limits.velocity.values[m] = random.size(10, 1000);
    limits.acceleration.values[m] = random.size(100, 20000);
    limits.jerk.values[m] = jerk_limited ? random.size(1e3, 1e7) : kInfinite;
  }
  return limits;
}

TEST(Interpolator, ALineFromRestToRestTakesTheLeastPossibleTime) {
  constexpr double kPeriod_s = 1e-5;
  SeededRandom random(kSeed);
  for (int i = 0; i < 1000; ++i) {
    const AxisLimits limits = random_limits(random);
    const TipPoint to{{random.in(-100, 100), random.in(-100, 100), random.in(-100, 100)}};
    const double feed = random.size(1, 1000);
    const double least = least_time_s(length_of(to), along(to, length_of(to), feed, limits));
    Interpolator interpolator(axes_named("XYZ"), limits, {.period_s = kPeriod_s});
    interpolator.take(test::motions_of({Line{to, {60 * feed}}}).front());
    interpolator.finish();
    interpolator.skip();
    ASSERT_GE(interpolator.time_s(), least * (1 - 1e-12)) << i;
    ASSERT_LE(interpolator.time_s(), least * (1 + 1e-12) + kPeriod_s) << i;
  }
}

// Nothing from rest to rest is faster than each of its axes alone would be.
TEST(Interpolator, IsNeverFasterThanOneOfItsAxesCouldBe) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 500; ++i) {
    const AxisLimits limits = random_limits(random);
    std::vector<Motion::Action> actions;
    TipPoint at;
    for (int n = random.count(2, 20); n > 0; --n) {
      for (std::size_t m = 0; m < kAxes; ++m) at.values[m] += random.in(0, 2);
      actions.push_back(Line{at, {60'000}});
    }
    Interpolator interpolator(axes_named("XYZ"), limits, {.tolerance_mm = 0.1});
    for (const Motion& motion : test::motions_of(actions)) interpolator.take(motion);
    interpolator.finish();
    interpolator.skip();
    for (std::size_t m = 0; m < kAxes; ++m) {
      const LineLimits axis{limits.velocity.values[m], limits.acceleration.values[m],
                            limits.jerk.values[m]};
      ASSERT_GE(interpolator.time_s(), least_time_s(at.values[m], axis) * (1 - 1e-9)) << i;
    }
  }
}

// Short lines with corners and without, arcs, rapids and dwells.
std::vector<Motion> many_motions(int count) {
  std::vector<Motion::Action> actions;
  for (int i = 0; i < count; ++i) {
    const double x = 3.0 * i;
    actions.push_back(Rapid{{{x, 1}}});
    for (int k = 1; k < 20; ++k)
      actions.push_back(Line{{{x + 0.05 * k, 1 + 0.01 * std::sin(0.3 * k)}}, {3000}});
    actions.push_back(Line{{{x + 1, 2}}, {3000}});
    actions.push_back(Arc{.to = {{x + 1, 3}}, .center = {x + 1, 2.5}, .feed = {3000}});
    actions.push_back(Dwell{0.002});
  }
  return test::motions_of(actions);
}

AxisLimits ordinary_limits(double jerk) { return test::equal_limits(500, 2000, jerk); }

TEST(Interpolator, PassingOverThePointsKeepsTheTime) {
  const std::vector<Motion> motions = many_motions(300);
  for (const double jerk : {kInfinite, 50'000.0}) {
    Interpolator made(axes_named("XYZ"), ordinary_limits(jerk), {});
    const auto points = test::points_of(made, motions);
    Interpolator passed(axes_named("XYZ"), ordinary_limits(jerk), {});
    test::pass_over(passed, motions);
    EXPECT_EQ(passed.time_s(), made.time_s());
    EXPECT_EQ(points.back().time_s, made.time_s());
  }
}

TEST(Interpolator, TwoRunsMakeTheSamePoints) {
  const std::vector<Motion> motions = many_motions(50);
  Interpolator one(axes_named("XYZ"), ordinary_limits(50'000), {});
  Interpolator other(axes_named("XYZ"), ordinary_limits(50'000), {});
  const auto points = test::points_of(one, motions);
  const auto again = test::points_of(other, motions);
  ASSERT_EQ(points.size(), again.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(points[i].tip, again[i].tip) << i;
    ASSERT_EQ(points[i].mark.block.line, again[i].mark.block.line) << i;
  }
}

TEST(Interpolator, ASetPointAllocatesNothing) {
  const std::vector<Motion> motions = many_motions(2000);
  for (const double jerk : {kInfinite, 50'000.0}) {
    Interpolator interpolator(axes_named("XYZ"), ordinary_limits(jerk), {});
    motion::Setpoint point;
    std::uint64_t points = 0;
    std::uint64_t before = 0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
      if (i == motions.size() / 2) before = test::allocations_so_far();
      if (!interpolator.room()) {
        while (interpolator.next(point)) ++points;
      }
      interpolator.take(motions[i]);
    }
    EXPECT_EQ(test::allocations_so_far(), before) << jerk;
    EXPECT_GT(points, 10'000U);
  }
}

}  // namespace
}  // namespace kerf::planner
