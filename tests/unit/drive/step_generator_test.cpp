#include "drive/step_generator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "allocation_count.hpp"
#include "drive/pulse_counter.hpp"
#include "drive_recorder.hpp"
#include "seeded_random.hpp"

namespace kerf::drive {
namespace {

using test::PulseRecorder;
using test::SeededRandom;

constexpr base::Axis kX{0};

/// Any rate that whole ns can tell apart.
StepTiming no_limits() {
  StepTiming timing;
  timing.pulse_width_ns = 1;
  timing.pulse_gap_ns = 1;
  timing.direction_setup_ns = 0;
  timing.band_steps = 1e-3;
  return timing;
}

JointMoment point(double time_s, double x, double y = 0) {
  JointMoment result{time_s, {}};
  result.joints.values[0] = x;
  result.joints.values[1] = y;
  return result;
}

std::string message_of(const base::Result<void>& result) {
  return result ? "no error" : result.error().message;
}

TEST(StepGenerator, StepsWhereTheLineIsHalfAStepAway) {
  PulseRecorder recorder;
  StepTiming timing;
  timing.band_steps = 0;
  StepGenerator generator({{"X", 100, 0}}, timing, recorder);
  generator.start(point(0, 0));
  ASSERT_TRUE(generator.move_to(point(1, 0.04)));
  const std::vector<Pulse> expected{{125'000'000, 2500, kX, Direction::positive},
                                    {375'000'000, 2500, kX, Direction::positive},
                                    {625'000'000, 2500, kX, Direction::positive},
                                    {875'000'000, 2500, kX, Direction::positive}};
  EXPECT_EQ(recorder.pulses, expected);
}

TEST(StepGenerator, PulsesOfTwoAxesLeaveInTheOrderOfTimeThenOfAxes) {
  PulseRecorder recorder;
  StepTiming timing;
  timing.band_steps = 0;
  StepGenerator generator({{"X", 100, 0}, {"Y", 100, 0}}, timing, recorder);
  generator.start(point(0, 0));
  ASSERT_TRUE(generator.move_to(point(1, 0.01, -0.03)));
  std::vector<std::pair<std::int64_t, std::size_t>> order;
  for (const Pulse& pulse : recorder.pulses) order.emplace_back(pulse.time_ns, index(pulse.axis));
  const std::vector<std::pair<std::int64_t, std::size_t>> expected{
      {166666667, 1}, {500000000, 0}, {500000000, 1}, {833333333, 1}};
  EXPECT_EQ(order, expected);
}

TEST(StepGenerator, NegativeStepsPerUnitTurnTheMotorRound) {
  PulseRecorder recorder;
  StepGenerator generator({{"X", -10, 0}}, {}, recorder);
  generator.start(point(0, 0));
  ASSERT_TRUE(generator.move_to(point(1, 0.3)));
  EXPECT_EQ(recorder.pulses.size(), 3U);
  EXPECT_EQ(recorder.pulses.front().direction, Direction::negative);
  EXPECT_EQ(generator.count(kX), -3);
}

TEST(StepGenerator, AnAxisBetweenTwoStepsDoesNotChatter) {
  PulseRecorder recorder;
  StepGenerator generator({{"X", 100, 0}}, {}, recorder);
  generator.start(point(0, 0));
  for (int i = 1; i <= 1000; ++i) {
    ASSERT_TRUE(generator.move_to(point(i * 1e-3, 0.005 + (i % 2 == 0 ? 1e-12 : -1e-12))));
  }
  EXPECT_TRUE(recorder.pulses.empty());
}

/// Random set-points on two axes, every millisecond.
std::vector<JointMoment> random_walk(unsigned seed, int points) {
  SeededRandom random(seed);
  std::vector<JointMoment> walk{point(0, random.in(-5, 5), random.in(-5, 5))};
  for (int i = 1; i < points; ++i) {
    const base::JointPoint& last = walk.back().joints;
    const double step = random.size(1e-6, 1);
    const bool rests = random.count(0, 9) == 0;
    walk.push_back(point(i * 1e-3, last.values[0] + (rests ? 0 : random.in(-step, step)),
                         last.values[1] + random.in(-step, step)));
  }
  return walk;
}

double line_at(const JointMoment& from, const JointMoment& to, std::size_t axis, double time_s) {
  const double part = (time_s - from.time_s) / (to.time_s - from.time_s);
  return from.joints.values[axis] + part * (to.joints.values[axis] - from.joints.values[axis]);
}

TEST(StepGenerator, IsNeverMoreThanHalfAStepFromTheLine) {
  constexpr std::array<double, 2> kPerUnit{1000, -333.25};
  for (unsigned seed = test::kSeed; seed < test::kSeed + 50; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<JointMoment> walk = random_walk(seed, 200);
    PulseRecorder recorder;
    const StepTiming timing = no_limits();
    StepGenerator generator({{"X", kPerUnit[0], 0}, {"Y", kPerUnit[1], 0}}, timing, recorder);
    generator.start(walk[0]);
    std::array<std::int64_t, 2> counts{generator.count(kX), generator.count(base::Axis{1})};
    std::size_t done = 0;
    std::int64_t last_ns = 0;
    for (std::size_t i = 1; i < walk.size(); ++i) {
      ASSERT_EQ(message_of(generator.move_to(walk[i])), "no error");
      for (; done < recorder.pulses.size(); ++done) {
        const Pulse& pulse = recorder.pulses[done];
        ASSERT_GE(pulse.time_ns, last_ns);
        last_ns = pulse.time_ns;
        const std::size_t axis = index(pulse.axis);
        const double time_s = static_cast<double>(pulse.time_ns) * 1e-9;
        const double line = line_at(walk[i - 1], walk[i], axis, time_s) * kPerUnit[axis];
        const double speed =
            std::abs(walk[i].joints.values[axis] - walk[i - 1].joints.values[axis]) * 1e3 *
            std::abs(kPerUnit[axis]);
        // Half a step before and after the pulse; 1 ns for rounding and for the test's own sums.
        const double most = 0.5 + timing.band_steps + speed * 1e-9 + 1e-9;
        ASSERT_LE(std::abs(line - static_cast<double>(counts[axis])), most);
        counts[axis] += sign(pulse.direction);
        ASSERT_LE(std::abs(line - static_cast<double>(counts[axis])), most);
      }
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double line = walk[i].joints.values[axis] * kPerUnit[axis];
        ASSERT_EQ(counts[axis], generator.count(static_cast<base::Axis>(axis)));
        ASSERT_LE(std::abs(line - static_cast<double>(counts[axis])), 0.5 + timing.band_steps);
      }
    }
  }
}

TEST(StepGenerator, CountsEqualWhatIsCommandedInWholeSteps) {
  SeededRandom random(test::kSeed);
  PulseCounter counter;
  StepGenerator generator({{"X", 640, 0}, {"Y", 200, 0}}, no_limits(), counter);
  generator.start(point(0, 0));
  for (int i = 1; i <= 20'000; ++i) {
    const int x = random.count(-5000, 5000);
    const int y = random.count(-5000, 5000);
    ASSERT_EQ(message_of(generator.move_to(point(i * 0.01, x / 640.0, y / 200.0))), "no error");
    ASSERT_EQ(counter.count(kX), x);
    ASSERT_EQ(counter.count(base::Axis{1}), y);
  }
}

TEST(StepGenerator, ALineInPiecesGivesThePulsesOfTheWholeLine) {
  PulseRecorder whole;
  PulseRecorder pieces;
  StepGenerator one({{"X", 1000, 0}}, no_limits(), whole);
  StepGenerator many({{"X", 1000, 0}}, no_limits(), pieces);
  one.start(point(0, 0.25));
  many.start(point(0, 0.25));
  ASSERT_TRUE(one.move_to(point(1, 2.25)));
  for (int i = 1; i <= 128; ++i) ASSERT_TRUE(many.move_to(point(i / 128.0, 0.25 + i / 64.0)));
  ASSERT_EQ(whole.pulses.size(), 2000U);
  ASSERT_EQ(pieces.pulses.size(), 2000U);
  for (std::size_t i = 0; i < 2000; ++i) {
    EXPECT_NEAR(static_cast<double>(whole.pulses[i].time_ns),
                static_cast<double>(pieces.pulses[i].time_ns), 1);
  }
}

TEST(StepGenerator, RunsAtTheMostRateOfAnAxis) {
  PulseRecorder recorder;
  StepGenerator generator({{"X", 1000, 100'000}}, {}, recorder);
  generator.start(point(0, 0));
  for (int i = 1; i <= 1000; ++i) {
    ASSERT_EQ(message_of(generator.move_to(point(i * 1e-3, i * 0.1))), "no error");
  }
  EXPECT_EQ(recorder.pulses.size(), 100'000U);
}

TEST(StepGenerator, ReportsAxisTimeAndRateOfAnAxisThatIsTooFast) {
  PulseRecorder recorder;
  StepGenerator generator({{"X", 1000, 0}, {"Y", 1000, 100'000}}, {}, recorder);
  generator.start(point(1, 0));
  const auto result = generator.move_to(point(1.5, 1, 62.5));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().number, "STEP_RATE");
  EXPECT_EQ(result.error().message,
            "steps cannot follow: axis Y at 1.000004 s: 125000 steps/s, at most 100000");
  EXPECT_TRUE(recorder.pulses.empty());
  EXPECT_TRUE(generator.move_to(point(1.5, 1, 1))) << "stands where it stood";
  EXPECT_EQ(generator.count(kX), 1000);
}

TEST(StepGenerator, TheAmplifiersPulseTimesLimitTheRate) {
  PulseRecorder recorder;
  StepTiming timing;
  timing.pulse_width_ns = 3000;
  timing.pulse_gap_ns = 2000;
  StepGenerator generator({{"X", 1000, 0}}, timing, recorder);
  generator.start(point(0, 0));
  EXPECT_TRUE(generator.move_to(point(1, 200)));
  EXPECT_EQ(message_of(generator.move_to(point(2, 401))),
            "steps cannot follow: axis X at 1.000002488 s: 201000 steps/s, at most 200000");
}

TEST(StepGenerator, ReportsAReversalThatLeavesNoTimeForTheDirection) {
  PulseRecorder recorder;
  StepTiming timing;
  timing.pulse_width_ns = 1000;
  timing.pulse_gap_ns = 1000;
  timing.direction_setup_ns = 5000;
  timing.band_steps = 0.25;  // the steps of the reversal are half a step apart
  StepGenerator slow({{"X", 1, 0}}, timing, recorder);
  slow.start(point(0, 0));
  ASSERT_TRUE(slow.move_to(point(12e-6, 0.75 + 1e-9)));
  EXPECT_TRUE(slow.move_to(point(24e-6, 0)));  // 8000 ns after
  StepGenerator fast({{"X", 1, 0}}, timing, recorder);
  fast.start(point(0, 0));
  ASSERT_TRUE(fast.move_to(point(6e-6, 0.75 + 1e-9)));
  EXPECT_EQ(message_of(fast.move_to(point(12e-6, 0))),
            "steps cannot follow: axis X at 0.00001 s: turns round 4000 ns after a step (250000 "
            "steps/s); pulse and direction need 6000 ns");
}

TEST(StepGenerator, AJumpIsAnError) {
  PulseRecorder recorder;
  StepGenerator generator({{"X", 1000, 0}}, {}, recorder);
  generator.start(point(0, 0));
  EXPECT_EQ(message_of(generator.move_to(point(0, 1))),
            "steps cannot follow: axis X at 0 s: two steps at once, at most 200000");
}

TEST(StepGenerator, APositionBeyondTheCounterIsAnError) {
  PulseRecorder recorder;
  StepGenerator generator({{"X", 1000, 0}}, {}, recorder);
  generator.start(point(0, 0));
  EXPECT_FALSE(generator.move_to(point(1, 1e12)));
  EXPECT_FALSE(generator.move_to(point(1, std::nan(""))));
}

TEST(StepGenerator, AllocatesNothing) {
  PulseCounter counter;
  StepGenerator generator({{"X", 1000, 0}, {"Y", 1000, 0}}, no_limits(), counter);
  generator.start(point(0, 0));
  const std::uint64_t before = test::allocations_so_far();
  for (int i = 1; i <= 10'000; ++i) {
    (void)generator.move_to(point(i * 1e-3, i * 0.1, -i * 0.05));
  }
  EXPECT_EQ(test::allocations_so_far(), before);
  EXPECT_EQ(counter.count(kX), 1'000'000);
}

}  // namespace
}  // namespace kerf::drive
