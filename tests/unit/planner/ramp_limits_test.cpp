#include "planner/ramp_limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "planner/profile.hpp"
#include "seeded_random.hpp"

namespace kerf::planner {
namespace {

using test::kSeed;
using test::SeededRandom;

constexpr std::size_t kAxes = 3;
constexpr double kRounding = 1 + 1e-12;

/// A part of a path, and a speed at which its shape leaves something of each limit.
struct Part {
  motion::CurveBounds bounds;
  AxisLimits limits;
  double speed = 0;
};

Part random_part(SeededRandom& random) {
  Part part;
  part.speed = random.size(0.1, 1000);
  const double shape = random.coin() ? 0.98 : random.in(0, 0.98);
  for (std::size_t m = 0; m < kAxes; ++m) {
    part.limits.velocity.values[m] = 2000;
    part.limits.acceleration.values[m] = random.size(10, 20000);
    part.limits.jerk.values[m] = random.size(100, 1e6);
    part.bounds.first.values[m] = random.in(0.01, 1);
    part.bounds.second.values[m] =
        random.in(0, shape) * part.limits.acceleration.values[m] / (part.speed * part.speed);
    part.bounds.third.values[m] =
        random.in(0, shape) * part.limits.jerk.values[m] / std::pow(part.speed, 3);
  }
  return part;
}

/// The most that an axis needs of its limits, as a share, in a ramp that ends at `speed`.
double most_needed(const Part& part, double speed, const RampLimits& ramp) {
  constexpr int kPlaces = 300;
  const double highest = std::min(ramp.acceleration, std::sqrt(ramp.jerk * speed));
  double most = 0;
  for (int i = 0; i <= kPlaces; ++i) {
    const double a = highest * i / kPlaces;
    const double v = speed - a * a / (2 * ramp.jerk);
    for (std::size_t m = 0; m < kAxes; ++m) {
      const double first = part.bounds.first.values[m];
      const double second = part.bounds.second.values[m];
      const double third = part.bounds.third.values[m];
      most = std::max({most, (first * a + second * v * v) / part.limits.acceleration.values[m],
                       (first * ramp.jerk + 3 * second * v * a + third * v * v * v) /
                           part.limits.jerk.values[m]});
    }
  }
  return most;
}

double time_s(const Part& part, const RampLimits& ramp) {
  return ramp_time_s(0, part.speed, {part.speed, ramp.acceleration, ramp.jerk});
}

/// The fastest of many pairs.
double fastest_s(const Part& part, const RampLimits& most) {
  constexpr int kTried = 60;
  double least = 1e300;
  for (int i = 1; i <= kTried; ++i) {
    for (int k = 1; k <= kTried; ++k) {
      const RampLimits ramp{most.acceleration * i / kTried, most.jerk * k / kTried};
      const double time = time_s(part, ramp);
      if (time < least && most_needed(part, part.speed, ramp) <= 1) least = time;
    }
  }
  return least;
}

RampLimits of(const Part& part) { return ramp_limits(part.bounds, part.limits, kAxes, part.speed); }

TEST(RampLimits, HoldWhereverARampIsInThem) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const Part part = random_part(random);
    const RampLimits ramp = of(part);
    ASSERT_GT(ramp.acceleration, 0);
    ASSERT_GT(ramp.jerk, 0);
    ASSERT_LE(most_needed(part, part.speed, ramp), kRounding);
    // Cells that become one section take the least of each.
    const RampLimits less{ramp.acceleration * random.in(0.1, 1), ramp.jerk * random.in(0.1, 1)};
    ASSERT_LE(most_needed(part, part.speed * random.in(0.1, 1), less), kRounding);
  }
}

TEST(RampLimits, AreNearlyTheFastestThatHold) {
  SeededRandom random(kSeed + 1);
  double worst = 0;
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const Part part = random_part(random);
    motion::CurveBounds straight = part.bounds;
    straight.second = straight.third = {};
    const RampLimits most = ramp_limits(straight, part.limits, kAxes, part.speed);
    worst = std::max(worst, time_s(part, of(part)) / fastest_s(part, most));
  }
  EXPECT_LT(worst, 1.1);
}

TEST(RampLimits, OnALineAreThoseOfTheAxes) {
  SeededRandom random(kSeed + 2);
  Part part = random_part(random);
  part.bounds.second = part.bounds.third = {};
  const RampLimits ramp = of(part);
  double acceleration = 1e300;
  double jerk = 1e300;
  for (std::size_t m = 0; m < kAxes; ++m) {
    acceleration =
        std::min(acceleration, part.limits.acceleration.values[m] / part.bounds.first.values[m]);
    jerk = std::min(jerk, part.limits.jerk.values[m] / part.bounds.first.values[m]);
  }
  EXPECT_EQ(ramp.acceleration, acceleration);
  EXPECT_EQ(ramp.jerk, jerk);
}

TEST(RampLimits, LeaveTheJerkFreeWhereNoAxisThatMovesHasALimitOfIt) {
  SeededRandom random(kSeed + 3);
  Part part = random_part(random);
  part.limits.jerk.values.fill(std::numeric_limits<double>::infinity());
  const RampLimits ramp = of(part);
  EXPECT_TRUE(std::isinf(ramp.jerk));
  EXPECT_GT(ramp.acceleration, 0);
  EXPECT_LE(most_needed(part, part.speed, {ramp.acceleration, 1e300}), kRounding);
}

}  // namespace
}  // namespace kerf::planner
