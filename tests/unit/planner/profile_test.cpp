#include "planner/profile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seeded_random.hpp"

namespace kerf::planner {
namespace {

using test::kSeed;
using test::SeededRandom;

constexpr double kPrinted = 5.001e-7;  // six decimals

/// How long a profile speeds up, cruises and slows down.
struct Parts {
  double up_s = 0;
  double cruise_s = 0;
  double down_s = 0;
  double up_mm = 0;
};

Parts parts_of(const Profile& profile) {
  Parts parts;
  bool at_peak = false;
  for (const Phase& phase : profile.phases()) {
    const bool steady = phase.acceleration == 0 && phase.jerk == 0;
    const bool rising = phase.acceleration > 0 || phase.jerk > 0;
    at_peak = at_peak || steady || (!rising && phase.acceleration == 0);
    if (steady) {
      parts.cruise_s += phase.duration_s;
    } else if (at_peak) {
      parts.down_s += phase.duration_s;
    } else {
      parts.up_s += phase.duration_s;
      parts.up_mm += phase.way(phase.duration_s);
    }
  }
  return parts;
}

struct RestToRest {
  double length, velocity, acceleration, jerk;
  double peak, up_s, cruise_s, down_s, total_s, up_mm;
};

constexpr RestToRest kRestToRest[] = {
    {100, 100, 1000, 10000, 100.000000, 0.200000, 0.800000, 0.200000, 1.200000, 10.000000},
    {100, 150, 1000, 10000, 150.000000, 0.250000, 0.416667, 0.250000, 0.916667, 18.750000},
    {10, 100, 1000, 10000, 62.996052, 0.158740, 0.000000, 0.158740, 0.317480, 5.000000},
    {1, 100, 1000, 10000, 13.572088, 0.073681, 0.000000, 0.073681, 0.147361, 0.500000},
    {0.1, 100, 1000, 10000, 2.924018, 0.034200, 0.000000, 0.034200, 0.068399, 0.050000},
    {500, 200, 2000, 8000, 200.000000, 0.316228, 2.183772, 0.316228, 2.816228, 31.622777},
};

TEST(Profile, FromRestToRestAsTheTableSays) {
  for (const RestToRest& row : kRestToRest) {
    const Profile profile(row.length, 0, 0, {row.velocity, row.acceleration, row.jerk});
    const Parts parts = parts_of(profile);
    EXPECT_NEAR(profile.peak(), row.peak, kPrinted) << row.length;
    EXPECT_NEAR(parts.up_s, row.up_s, kPrinted) << row.length;
    EXPECT_NEAR(parts.cruise_s, row.cruise_s, kPrinted) << row.length;
    EXPECT_NEAR(parts.down_s, row.down_s, kPrinted) << row.length;
    EXPECT_NEAR(parts.up_mm, row.up_mm, kPrinted) << row.length;
    EXPECT_NEAR(profile.duration_s(), row.total_s, kPrinted) << row.length;
  }
}

TEST(Profile, StatesOnTheWayAsTheTableSays) {
  constexpr struct {
    double t, s, v, a;
  } kRows[] = {
      {0.05, 0.208333, 12.500000, 500.000000}, {0.1, 1.666667, 50.000000, 1000.000000},
      {0.15, 5.208333, 87.500000, 500.000000}, {0.2, 10.000000, 100.000000, 0.000000},
      {0.5, 40.000000, 100.000000, 0.000000},  {1.0, 90.000000, 100.000000, 0.000000},
      {1.05, 94.791667, 87.500000, -500.0},    {1.15, 99.791667, 12.500000, -500.0},
      {1.2, 100.000000, 0.000000, 0.000000},
  };
  const Profile profile(100, 0, 0, {100, 1000, 10000});
  for (const auto& row : kRows) {
    const Profile::State state = profile.state_at(row.t);
    EXPECT_NEAR(state.position, row.s, kPrinted) << row.t;
    EXPECT_NEAR(state.velocity, row.v, kPrinted) << row.t;
    EXPECT_NEAR(state.acceleration, row.a, kPrinted) << row.t;
  }
}

TEST(Profile, BetweenTwoSpeedsAsTheTableSays) {
  constexpr struct {
    double entry, exit, length, velocity, acceleration, jerk;
    double peak, up_s, cruise_s, down_s, total_s;
  } kRows[] = {
      {20, 50, 30, 100, 1000, 10000, 100.000000, 0.178885, 0.086603, 0.141421, 0.406910},
      {50, 0, 10, 100, 1000, 10000, 65.993921, 0.079985, 0.000000, 0.162473, 0.242458},
      {0, 80, 12, 100, 1000, 20000, 96.045828, 0.146046, 0.000000, 0.056649, 0.202695},
      {60, 60, 5, 100, 500, 5000, 62.096261, 0.040951, 0.000000, 0.040951, 0.081903},
  };
  for (const auto& row : kRows) {
    const Profile profile(row.length, row.entry, row.exit,
                          {row.velocity, row.acceleration, row.jerk});
    const Parts parts = parts_of(profile);
    EXPECT_NEAR(profile.peak(), row.peak, kPrinted) << row.length;
    EXPECT_NEAR(parts.up_s, row.up_s, kPrinted) << row.length;
    EXPECT_NEAR(parts.cruise_s, row.cruise_s, kPrinted) << row.length;
    EXPECT_NEAR(parts.down_s, row.down_s, kPrinted) << row.length;
    EXPECT_NEAR(profile.duration_s(), row.total_s, kPrinted) << row.length;
  }
}

struct RandomProfile {
  PathLimits limits;
  double entry = 0;
  double exit = 0;
  double length = 0;
};

RandomProfile random_profile(SeededRandom& random) {
  RandomProfile made;
  made.limits.velocity = random.size(0.1, 1000);
  made.limits.acceleration = random.size(1, 1e5);
  if (random.coin()) made.limits.jerk = random.size(1, 1e7);
  made.entry = random.coin() ? 0 : random.in(0, made.limits.velocity);
  made.exit = random.coin() ? 0 : random.in(0, made.limits.velocity);
  made.length = ramp_length(made.entry, made.exit, made.limits) + random.size(1e-6, 1e4);
  return made;
}

// Each phase begins in the state in which the one before ends.
TEST(Profile, CoversItsLengthWithinItsLimitsFromEntryToExit) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 20'000; ++i) {
    const RandomProfile made = random_profile(random);
    const Profile profile(made.length, made.entry, made.exit, made.limits);
    const Profile::State begin = profile.state_at(0);
    const Profile::State end = profile.state_at(profile.duration_s() * 1.01);
    ASSERT_EQ(begin.position, 0);
    ASSERT_NEAR(begin.velocity, made.entry, 1e-9 * made.limits.velocity) << i;
    ASSERT_NEAR(end.position, made.length, 1e-9 * (1 + made.length)) << i;
    ASSERT_NEAR(end.velocity, made.exit, 1e-9 * made.limits.velocity) << i;
    double velocity = made.entry;
    double acceleration = 0;
    for (const Phase& phase : profile.phases()) {
      ASSERT_NEAR(phase.velocity, velocity, 1e-9 * made.limits.velocity) << i;
      if (std::isfinite(made.limits.jerk)) {
        ASSERT_NEAR(phase.acceleration, acceleration, 1e-9 * made.limits.acceleration) << i;
        ASSERT_LE(std::fabs(phase.jerk), made.limits.jerk) << i;
      }
      velocity = phase.velocity_at(phase.duration_s);
      acceleration = phase.acceleration_at(phase.duration_s);
      for (const double a : {phase.acceleration, acceleration})
        ASSERT_LE(std::fabs(a), made.limits.acceleration * (1 + 1e-9)) << i;
      ASSERT_LE(velocity, made.limits.velocity * (1 + 1e-9)) << i;
      ASSERT_GE(velocity, -1e-9 * made.limits.velocity) << i;
    }
  }
}

// What is left of a path behind a replanned ramp may be a last digit long, and the two speeds a
// last digit apart: the ramp between them would be a million times longer.
TEST(Profile, IsNoLongerThanItsLengthWhereRoundingLeavesNoRamp) {
  const PathLimits limits{5.45533043, 9.73899459, 297.784536};
  const double entry = 4.6704097448;
  const double length = 2.77555756156e-17;
  const Profile profile(length, entry, std::nextafter(entry, 5), limits);
  EXPECT_GT(ramp_length(entry, std::nextafter(entry, 5), limits), 1e6 * length);
  EXPECT_NEAR(profile.state_at(1).position, length, 1e-3 * length);
  EXPECT_DOUBLE_EQ(profile.state_at(1).velocity, entry);
  EXPECT_TRUE(Profile(0, entry, std::nextafter(entry, 5), limits).phases().empty());
}

TEST(Profile, IsTheFastestOfItsKind) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 5'000; ++i) {
    const RandomProfile made = random_profile(random);
    const Profile profile(made.length, made.entry, made.exit, made.limits);
    if (profile.peak() >= made.limits.velocity * (1 - 1e-9)) continue;
    const double higher = profile.peak() * (1 + 1e-6) + 1e-9;
    EXPECT_GT(
        ramp_length(made.entry, higher, made.limits) + ramp_length(made.exit, higher, made.limits),
        made.length)
        << i;
  }
}

TEST(Profile, WhatIsReachedAtMostIsTheLessOfBoth) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 100'000; ++i) {
    PathLimits limits{500, random.size(1, 1e4)};
    if (random.coin()) limits.fall = random.size(1e-6, 1e-2);
    if (random.coin()) limits = {500, random.size(1, 1e4), random.size(10, 1e6)};
    const double from = random.in(0, 100);
    const double length = random.size(1e-3, 100);
    const double reached = reachable_speed(from, length, limits);
    for (const double most : {reached, std::nextafter(reached, 0), std::nextafter(reached, 1e9),
                              reached * random.in(0.5, 2), 500.0})
      ASSERT_EQ(reachable_speed(from, length, limits, most), std::min(most, reached)) << i;
  }
}

// s³ + 2 v s = L √j with s = √Δv while the acceleration is not reached; then
// Δv² + Δv (2v + a²/j) + 2 v a²/j = 2 a L; without a limit of the jerk v1² = v0² + 2 a L.
TEST(Profile, TheReachableSpeedSolvesTheEquationOfTheRamp) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 20'000; ++i) {
    PathLimits limits{1e9, random.size(1, 1e5), random.size(1, 1e7)};
    const double from = random.coin() ? 0 : random.size(0.01, 1000);
    const double length = random.size(1e-6, 1e3);
    const double change = reachable_speed(from, length, limits) - from;
    const double full = limits.acceleration * limits.acceleration / limits.jerk;
    const double s = std::sqrt(change);
    const double left = change <= full
                            ? s * s * s + 2 * from * s
                            : change * change + change * (2 * from + full) + 2 * from * full;
    const double right =
        change <= full ? length * std::sqrt(limits.jerk) : 2 * limits.acceleration * length;
    // Where the ramp changes little a digit of the speed is many of the change.
    const double rounding = 1e-9 + 1e-14 * from / change;
    ASSERT_NEAR(left / right, 1, rounding) << i;
    limits.jerk = std::numeric_limits<double>::infinity();
    const double speed = reachable_speed(from, length, limits);
    ASSERT_NEAR(speed * speed, from * from + 2 * limits.acceleration * length,
                1e-12 * speed * speed);
  }
}

}  // namespace
}  // namespace kerf::planner
