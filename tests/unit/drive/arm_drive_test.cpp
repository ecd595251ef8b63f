// The arm's pulses: numbers of motor and timer, splitting of moves, edges, ramps, the way home.
#include "drive/arm_drive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "allocation_count.hpp"
#include "drive/arm_motor.hpp"
#include "drive/pulse_counter.hpp"
#include "drive_recorder.hpp"
#include "seeded_random.hpp"

namespace kerf::drive {
namespace {

using test::PulseRecorder;
using test::SeededRandom;

constexpr double kLink = 132;  // mm
const TickClock kClock;

struct Edges {
  std::vector<std::int64_t> rises, falls;
};

/// Edges of one axis, in ticks.
Edges edges_of(const std::vector<Pulse>& pulses, ArmAxis axis) {
  Edges edges;
  for (const Pulse& pulse : pulses) {
    if (pulse.axis != axis_of(axis)) continue;
    edges.rises.push_back(kClock.ticks(static_cast<double>(pulse.time_ns) * 1e-9));
    edges.falls.push_back(kClock.ticks(static_cast<double>(pulse.time_ns + pulse.width_ns) * 1e-9));
  }
  return edges;
}

ArmSettings settings_of(TimerSplit split) {
  ArmSettings settings;
  settings.split = split;
  return settings;
}

TEST(ArmMotor, SpeedRateAndTimerCountOfACut) {
  const ArmMotor motor;
  const double shaft = motor.shaft_deg_s(1.3, kLink);
  EXPECT_NEAR(shaft, 84.641492, 5e-7);
  EXPECT_NEAR(motor.rate_hz(84.6), 112.8, 1e-9);
  EXPECT_NEAR(motor.rate_hz(shaft), 112.855323, 5e-7);
  EXPECT_NEAR(half_period_s(112.8) * 1e3, 4.432624, 5e-7);
  EXPECT_NEAR(half_period_s(motor.rate_hz(shaft)) * 1e3, 4.430451, 5e-7);
  EXPECT_NEAR(kClock.tick_s() * 1e6, 1.085069, 5e-7);
  EXPECT_NEAR(half_period_s(112.8) / kClock.tick_s(), 4085.106, 5e-4);
  EXPECT_EQ(kClock.ticks(half_period_s(112.8)), 0xFF5);
  EXPECT_EQ(kClock.ticks(half_period_s(motor.rate_hz(shaft))), 4083);
  EXPECT_EQ(timer_initial_value(0x1000), 0xF000);
}

TEST(ArmMotor, WhatTheRoundedCountReallyGives) {
  const ArmMotor motor;
  const double half_s = 0x1000 * kClock.tick_s();
  const double rate_hz = 1 / (2 * half_s);
  const double joint_deg_s = rate_hz * motor.joint_step_deg();
  EXPECT_NEAR(half_s * 1e3, 4.444444, 5e-7);
  EXPECT_NEAR(rate_hz, 112.5, 1e-9);
  EXPECT_NEAR(rate_hz * motor.step_deg, 84.375, 1e-9);
  EXPECT_NEAR(joint_deg_s, 0.5625, 1e-12);
  EXPECT_NEAR(speed_at_radius_mm_s(kLink, joint_deg_s), 1.295907, 5e-7);
  EXPECT_NEAR(speed_at_radius_mm_s(2 * kLink, joint_deg_s), 2.591814, 5e-7) << "upper arm alone";
  // Both: the forearm turns at twice the speed about an elbow that moves.
  EXPECT_NEAR(
      speed_at_radius_mm_s(kLink, joint_deg_s) + speed_at_radius_mm_s(kLink, 2 * joint_deg_s),
      3.887721, 5e-7);
  EXPECT_NEAR(speed_at_radius_mm_s(kLink, motor.joint_step_deg()), 0.011519, 5e-7);
  EXPECT_NEAR(speed_at_radius_mm_s(2 * kLink, motor.joint_step_deg()), 0.023038, 5e-7);
  EXPECT_NEAR(kMostPulses * motor.joint_step_deg(), 327.675, 1e-9);
}

TEST(TickClock, RoundsAnExactFractionOnce) {
  EXPECT_EQ(kClock.nanoseconds(0), 0);
  EXPECT_EQ(kClock.nanoseconds(1), 1085);
  EXPECT_EQ(kClock.nanoseconds(72), 78125);
  EXPECT_EQ(kClock.nanoseconds(36), 39063) << "39062.5";
  EXPECT_EQ(kClock.nanoseconds(921'600LL * 1'000'000), 1'000'000'000'000'000);
}

struct SlowCase {
  SlowMove move;
  std::vector<SlowMove> triplets;
};

std::vector<SlowMove> split(const SlowMove& move) {
  std::vector<SlowMove> triplets;
  SlowMoveSplitter splitter(move);
  while (const auto triplet = splitter.next()) triplets.push_back(*triplet);
  return triplets;
}

TEST(SlowMove, SplitsIntoTriplets) {
  const std::vector<SlowCase> cases{
      {{0, 12, -7}, {{0, 12, -7}}},
      {{0, 45, 10}, {{0, 22, 5}, {0, 23, 5}}},
      {{4, 61, -100}, {{4, 15, -25}, {0, 15, -25}, {0, 15, -25}, {0, 16, -25}}},
      {{70, 5, 5}, {{30, 0, 0}, {30, 0, 0}, {10, 5, 5}}},
      {{-35, 0, 0}, {{-30, 0, 0}, {-5, 0, 0}}},
      {{0, 0, 0}, {}},
      {{2, 31, 0}, {{2, 15, 0}, {0, 16, 0}}},
      {{0, -90, 89}, {{0, -30, 29}, {0, -30, 30}, {0, -30, 30}}},
  };
  for (const SlowCase& one : cases) EXPECT_EQ(split(one.move), one.triplets);
}

TEST(SlowMove, TripletsAddUpAndStayWithinAPulseOfTheLine) {
  SeededRandom random(test::kSeed);
  for (int i = 0; i < 20'000; ++i) {
    const int size = random.count(0, 500);
    const SlowMove move{random.count(-size, size), random.count(-size, size),
                        random.count(-size, size)};
    SlowMove sum;
    const std::vector<SlowMove> triplets = split(move);
    const auto arms = [](const SlowMove& m) { return m.theta1 != 0 || m.theta2 != 0; };
    const auto parts = std::count_if(triplets.begin(), triplets.end(), arms);
    std::int64_t part = 0;
    for (const SlowMove& triplet : triplets) {
      ASSERT_NE(triplet, SlowMove{});
      for (const std::int64_t n : {triplet.theta3, triplet.theta1, triplet.theta2})
        ASSERT_LE(std::abs(n), kMostTripletPulses);
      sum = {sum.theta3 + triplet.theta3, sum.theta1 + triplet.theta1, sum.theta2 + triplet.theta2};
      if (!arms(triplet)) continue;
      ++part;
      ASSERT_EQ(sum.theta3, move.theta3) << "the wheel has turned before the arms move";
      ASSERT_LT(std::abs(sum.theta1 * parts - move.theta1 * part), parts);
      ASSERT_LT(std::abs(sum.theta2 * parts - move.theta2 * part), parts);
    }
    ASSERT_EQ(sum, move);
  }
}

struct TimerCase {
  std::int64_t most, pulses, count;
  int initial;  // -1: overflow
  double most_ms, pulses_ms;
  std::int64_t gap;
};

TEST(TimerSplit, IntegerModeLoadsWholeTicks) {
  const std::vector<TimerCase> cases{
      {1, 1, 0x1000, 0xF000, 8.888889, 8.888889, 0},
      {10, 7, 0x16DB, 0xE925, 88.888889, 88.882378, 6},
      {30, 30, 0x1000, 0xF000, 266.666667, 266.666667, 0},
      {30, 29, 0x108D, 0xEF73, 266.666667, 266.651476, 14},
      {30, 2, 0xF000, 0x1000, 266.666667, 266.666667, 0},
      {16, 1, 0x10000, 0x0000, 142.222222, 142.222222, 0},
      {17, 1, 0x11000, -1, 151.111111, 0, 0},
      {30, 1, 0x1E000, -1, 266.666667, 0, 0},
      {7, 3, 0x2555, 0xDAAB, 62.222222, 62.220052, 2},
  };
  for (const TimerCase& one : cases) {
    SCOPED_TRACE(std::to_string(one.most) + " : " + std::to_string(one.pulses));
    const auto half = split_half_period(TimerSplit::integer, one.most, one.pulses, 0x1000);
    const std::int64_t end = 2 * one.most * 0x1000;
    EXPECT_NEAR(static_cast<double>(end) * kClock.tick_s() * 1e3, one.most_ms, 5e-7);
    ASSERT_EQ(half.has_value(), one.initial >= 0);
    if (!half) {
      EXPECT_EQ(half.error().number, "TIMER_OVERFLOW");
      continue;
    }
    EXPECT_EQ(half->edge(1), one.count);
    EXPECT_EQ(timer_initial_value(half->edge(1)), one.initial);
    const std::int64_t last = half->edge(2 * one.pulses);
    EXPECT_NEAR(static_cast<double>(last) * kClock.tick_s() * 1e3, one.pulses_ms, 5e-7);
    EXPECT_EQ(end - last, one.gap);
  }
}

TEST(TimerSplit, AnOverflowSaysWhatIsNeeded) {
  const auto half = split_half_period(TimerSplit::integer, 30, 1, 0x1000);
  ASSERT_FALSE(half);
  EXPECT_EQ(half.error().message,
            "timer overflow: 1 pulses in the time of 30 need a half period of 122880 ticks "
            "(1E000H); the timer counts at most 65536 (10000H)");
  EXPECT_EQ(split_half_period(TimerSplit::exact, 30, 1, 0x1000)->edge(1), 122880);
}

TEST(ArmDrive, EdgesOfFiveAndThreePulsesInWholeTicks) {
  PulseRecorder recorder;
  ArmDrive drive(settings_of(TimerSplit::integer), recorder);
  ASSERT_TRUE(drive.slow({0, 5, -3}));
  const Edges most = edges_of(recorder.pulses, ArmAxis::theta1);
  const Edges fewer = edges_of(recorder.pulses, ArmAxis::theta2);
  using Ticks = std::vector<std::int64_t>;
  EXPECT_EQ(most.rises, (Ticks{4096, 12288, 20480, 28672, 36864}));
  EXPECT_EQ(most.falls, (Ticks{8192, 16384, 24576, 32768, 40960}));
  EXPECT_EQ(fewer.rises, (Ticks{6826, 20478, 34130}));
  EXPECT_EQ(fewer.falls, (Ticks{13652, 27304, 40956}));
}

TEST(ArmDrive, EdgesOfFiveAndThreePulsesExactly) {
  PulseRecorder recorder;
  ArmDrive drive({}, recorder);
  ASSERT_TRUE(drive.slow({0, -3, 5}));
  const Edges fewer = edges_of(recorder.pulses, ArmAxis::theta1);
  using Ticks = std::vector<std::int64_t>;
  EXPECT_EQ(fewer.rises, (Ticks{6827, 20480, 34133}));
  EXPECT_EQ(fewer.falls, (Ticks{13653, 27307, 40960}));
  EXPECT_EQ(recorder.pulses.front().time_ns, 4'444'444) << "4096 ticks";
}

TEST(ArmDrive, TheWheelTurnsBeforeTheArmsMove) {
  PulseRecorder recorder;
  ArmDrive drive({}, recorder);
  ASSERT_TRUE(drive.slow({-2, 3, 0}));
  const Edges wheel = edges_of(recorder.pulses, ArmAxis::theta3);
  const Edges arm = edges_of(recorder.pulses, ArmAxis::theta1);
  using Ticks = std::vector<std::int64_t>;
  EXPECT_EQ(wheel.rises, (Ticks{4096, 12288}));
  EXPECT_EQ(arm.rises, (Ticks{20480, 28672, 36864}));
  EXPECT_EQ(edges_of(recorder.pulses, ArmAxis::theta2).rises, Ticks{});
  EXPECT_EQ(drive.now_ticks(), 10 * 4096);
  EXPECT_EQ(drive.counters(), (ArmCounts{{3, 0, -2, 0}}));
}

TEST(ArmDrive, AnOverflowMovesNothing) {
  PulseRecorder recorder;
  ArmDrive drive(settings_of(TimerSplit::integer), recorder);
  EXPECT_FALSE(drive.slow({5, 17, 1}));
  EXPECT_TRUE(recorder.pulses.empty());
  EXPECT_EQ(drive.now_ticks(), 0);
}

TEST(ArmDrive, BothArmsEndTogetherAndStayWithinHalfAPulse) {
  for (std::int64_t most = 1; most <= 60; ++most) {
    for (std::int64_t fewer = 1; fewer <= most; ++fewer) {
      PulseRecorder recorder;
      ArmDrive drive({}, recorder);
      ASSERT_TRUE(drive.slow({0, most, -fewer}));
      const Edges first = edges_of(recorder.pulses, ArmAxis::theta1);
      const Edges second = edges_of(recorder.pulses, ArmAxis::theta2);
      const std::int64_t end = 2 * most * 4096;
      ASSERT_EQ(first.falls.back(), end);
      ASSERT_EQ(second.falls.back(), end);
      ASSERT_EQ(second.rises.size(), static_cast<std::size_t>(fewer));
      for (std::size_t k = 0; k < second.rises.size(); ++k) {
        const auto line = static_cast<double>(second.rises[k] * fewer) / static_cast<double>(end);
        const double tick = static_cast<double>(fewer) / static_cast<double>(end);
        ASSERT_LE(std::abs(line - static_cast<double>(k)), 0.5 + 0.51 * tick);
        ASSERT_LE(std::abs(line - static_cast<double>(k + 1)), 0.5 + 0.51 * tick);
      }
    }
  }
}

TEST(ArmDrive, FourMotorsCanBeLinked) {
  PulseRecorder recorder;
  ArmDrive drive({}, recorder);
  ASSERT_TRUE(drive.linked({{7, -30, 1, 2}}));
  for (const ArmAxis axis : {ArmAxis::theta1, ArmAxis::theta2, ArmAxis::theta3, ArmAxis::z})
    EXPECT_EQ(edges_of(recorder.pulses, axis).falls.back(), 60 * 4096);
  EXPECT_EQ(drive.counters(), (ArmCounts{{7, -30, 1, 2}}));
}

TEST(ArmDrive, TheToolKeepsItsSpeed) {
  const double tick_s = kClock.tick_s();
  // 0.3 mm in 30 pulses: at 1.3 mm/s 0.230769 s, 60 half periods.
  const std::int64_t half = speed_true_half_period(0.3, 1.3, tick_s, 30, 2000);
  EXPECT_EQ(half, 3545);
  EXPECT_NEAR(0.3 / (60 * static_cast<double>(half) * tick_s), 1.3, 2e-4);
  EXPECT_EQ(speed_true_half_period(0.1, 1.3, tick_s, 30, 2000), 2000) << "the motor's limit";
  EXPECT_EQ(speed_true_half_period(0, 1.3, tick_s, 0, 2000), 2000);
  PulseRecorder recorder;
  ArmDrive drive({}, recorder);
  ASSERT_TRUE(drive.slow({1, 30, 15}, half));
  EXPECT_EQ(drive.now_ticks(), 2 * 4096 + 60 * half) << "the wheel keeps the setting's";
}

TEST(FastProfile, RampsLinearlyAndBack) {
  const FastRamp ramp{400, 100, 1000};
  // 0.3 s and 75 pulses each ramp, 350 pulses at 400/s between.
  const FastProfile profile(ramp, 500);
  EXPECT_NEAR(profile.edge_s(2 * 75), 0.3, 1e-12);
  EXPECT_NEAR(profile.edge_s(2 * 250), 0.3 + 175 / 400.0, 1e-12);
  EXPECT_NEAR(profile.edge_s(2 * 425), 0.3 + 350 / 400.0, 1e-12);
  EXPECT_NEAR(profile.edge_s(2 * 500), 0.6 + 350 / 400.0, 1e-12);
  for (int edge = 1; edge < 1000; ++edge) {
    EXPECT_NEAR(profile.edge_s(edge) + profile.edge_s(1000 - edge), profile.edge_s(1000), 1e-12);
    EXPECT_GT(profile.edge_s(edge + 1), profile.edge_s(edge));
  }
}

TEST(FastProfile, AShortMoveTurnsRoundBelowTheRate) {
  const FastProfile profile({400, 100, 1000}, 30);  // 200/s after 15 pulses, 0.1 s
  EXPECT_NEAR(profile.edge_s(30), 0.1, 1e-12);
  EXPECT_NEAR(profile.edge_s(60), 0.2, 1e-12);
}

TEST(ArmDrive, AFastMoveNeverExceedsItsRate) {
  PulseRecorder recorder;
  ArmDrive drive({}, recorder);
  drive.fast({ArmAxis::theta2, -70'000});
  ASSERT_EQ(recorder.pulses.size(), 70'000U);
  std::int64_t last = 0;
  for (const Pulse& pulse : recorder.pulses) {
    ASSERT_GE(pulse.time_ns - last, last == 0 ? 0 : 1'000'000'000 / 400 - 1086);
    last = pulse.time_ns;
  }
  EXPECT_EQ(drive.counters()[ArmAxis::theta2], -70'000);
}

TEST(ArmDrive, ReplayedPulsesGiveTheCounters) {
  SeededRandom random(test::kSeed);
  PulseRecorder recorder;
  ArmDrive drive({}, recorder);
  ArmCounts commanded;
  for (int i = 0; i < 2000; ++i) {
    if (random.count(0, 9) == 0) {
      const FastMove move{static_cast<ArmAxis>(random.count(0, 3)), random.count(-300, 300)};
      drive.fast(move);
      commanded[move.axis] += move.count;
    } else {
      const SlowMove move{random.count(-9, 9), random.count(-30, 30), random.count(-30, 30)};
      ASSERT_TRUE(drive.slow(move));
      commanded[ArmAxis::theta3] += move.theta3;
      commanded[ArmAxis::theta1] += move.theta1;
      commanded[ArmAxis::theta2] += move.theta2;
    }
  }
  PulseCounter replay;
  std::int64_t last = 0;
  for (const Pulse& pulse : recorder.pulses) {
    ASSERT_GE(pulse.time_ns, last);
    last = pulse.time_ns;
    replay.take(pulse);
  }
  EXPECT_EQ(drive.counters(), commanded);
  for (std::size_t i = 0; i < kArmAxes; ++i)
    EXPECT_EQ(replay.count(static_cast<base::Axis>(i)), commanded.values[i]);
}

TEST(ReturnToStart, LiftsFirstAndLowersLast) {
  using enum ArmAxis;
  const std::array<FastMove, 5> expected{FastMove{z, 300}, FastMove{theta3, 7},
                                         FastMove{theta1, -40}, FastMove{theta2, 50},
                                         FastMove{z, -500}};
  EXPECT_EQ(return_to_start({{40, -50, -7, 200}}, 500), expected);
}

TEST(ReturnToStart, EndsAtZeroFromAnywhere) {
  SeededRandom random(test::kSeed);
  for (int i = 0; i < 300; ++i) {
    PulseRecorder recorder;
    ArmDrive broken_off({}, recorder);
    ASSERT_TRUE(broken_off.slow({random.count(-30, 30), random.count(-30, 30), 30}));
    broken_off.fast({ArmAxis::z, random.count(-900, 900)});
    // Stopped after any of its pulses.
    PulseCounter counter;
    const int stop = random.count(0, static_cast<int>(recorder.pulses.size()));
    for (int k = 0; k < stop; ++k) counter.take(recorder.pulses[static_cast<std::size_t>(k)]);
    ArmCounts stands;
    for (std::size_t k = 0; k < kArmAxes; ++k)
      stands.values[k] = counter.count(static_cast<base::Axis>(k));
    PulseCounter ignored;
    ArmDrive drive({}, ignored);
    drive.set_counters(stands);
    for (const FastMove& move : return_to_start(stands, 500)) drive.fast(move);
    ASSERT_EQ(drive.counters(), ArmCounts{});
  }
}

TEST(ArmDrive, AllocatesNothing) {
  PulseCounter counter;
  ArmDrive drive({}, counter);
  const std::uint64_t before = test::allocations_so_far();
  for (int i = 0; i < 1000; ++i) {
    SlowMoveSplitter splitter({70, 61, -100});
    while (const auto triplet = splitter.next()) (void)drive.slow(*triplet);
    drive.fast({ArmAxis::z, i});
  }
  EXPECT_EQ(test::allocations_so_far(), before);
}

}  // namespace
}  // namespace kerf::drive
