// Patterns on the machine: where its counters and joints stand, and when.
#include "engraver/pattern_replay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "drive/pattern/split.hpp"
#include "drive/return_to_start.hpp"
#include "seeded_random.hpp"
#include "set_machine.hpp"

namespace kerf::engraver {
namespace {

using base::AxisVector;
using base::TipPoint;
using drive::ArmAxis;
using drive::ArmCounts;
using drive::FastRecord;
using drive::Triplet;
using machine::PatternMachine;
using test::machine_with;

TEST(PatternReplay, ReturnsToStartFromAnywhere) {
  const auto definition = machine_with("arm4");
  const auto motors = *PatternMachine::of(definition);
  PatternReplay replay(motors);
  test::SeededRandom random(test::kSeed + 5);
  for (int i = 0; i < 50; ++i) {
    const auto axis = static_cast<ArmAxis>(random.count(0, 3));
    drive::each_record(drive::FastMove{axis, random.count(-2000, 2000)},
                       [&](const FastRecord& record) { ASSERT_TRUE(replay.take(record)); });
    drive::each_record(
        drive::SlowMove{random.count(-40, 40), random.count(-90, 90), random.count(-90, 90)},
        [&](const Triplet& record) { ASSERT_TRUE(replay.take(record)); });
  }
  for (const drive::FastMove& move : drive::return_to_start(replay.counters(), 200)) {
    drive::each_record(move, [&](const FastRecord& record) { ASSERT_TRUE(replay.take(record)); });
  }
  EXPECT_EQ(replay.counters(), ArmCounts{});
}

TEST(PatternReplay, LinksFourMotorsInTheTimeOfTheOneWithTheMostPulses) {
  const auto definition = machine_with("arm4");
  const auto motors = *PatternMachine::of(definition);
  PatternReplay replay(motors);
  const ArmCounts counts{{-40, 25, 3, 100}};
  ASSERT_TRUE(replay.take(drive::ListedLinked{counts}));
  EXPECT_EQ(replay.counters(), counts);
  EXPECT_EQ(replay.totals().linked, 1U);
  EXPECT_EQ(replay.totals().pulses, 168U);
  const double tick_s = 12 / 11.0592e6;
  EXPECT_NEAR(replay.time_s(), 2 * 100 * 4096 * tick_s, 1e-9);
  EXPECT_EQ(replay.statistics().motions(), 1U);
}

TEST(PatternReplay, TellsTheFirstPlaceBeyondTheTravelOfEachJoint) {
  const auto definition = machine_with("arm4");
  const auto motors = *PatternMachine::of(definition);
  PatternReplay replay(motors);
  ASSERT_TRUE(replay.take(FastRecord{ArmAxis::theta1, {40000, false}}));
  ASSERT_TRUE(replay.take(FastRecord{ArmAxis::theta1, {100, false}}));
  ASSERT_TRUE(replay.take(FastRecord{ArmAxis::z, {20000, false}}));
  ASSERT_EQ(replay.beyond_travel().size(), 2U);
  EXPECT_EQ(replay.beyond_travel()[0].record, 1U);
  EXPECT_TRUE(replay.beyond_travel()[0].sentence.starts_with("T1 goes to 200"));
  EXPECT_EQ(replay.beyond_travel()[1].record, 3U);
  EXPECT_TRUE(replay.beyond_travel()[1].sentence.starts_with("Z goes to 200"));
}

struct Points : motion::AxisPointSink {
  void take(const motion::AxisPoint& point) override { points.push_back(point); }
  std::vector<motion::AxisPoint> points;
};

TEST(PatternReplay, SetPointsLieOnTheLinesOfThePulses) {
  const auto definition = machine_with("arm4");
  const auto motors = *PatternMachine::of(definition);
  PatternReplay replay(motors);
  Points sink;
  replay.add_sink(sink);
  ASSERT_TRUE(replay.take(Triplet{
      {drive::pulse_field(2), drive::pulse_field(5), drive::pulse_field(-3)}, Triplet::kAxes}));
  replay.finish();
  // 2 pulses of the wheel, then 5 of the forearm: 14 half periods of 4096 ticks.
  const double half_s = 4096 * 12 / 11059200.0;
  EXPECT_EQ(sink.points.size(), static_cast<std::size_t>(std::ceil(14 * half_s / 0.001)));
  for (const motion::AxisPoint& point : sink.points) {
    const double wheel = std::min(1.0, point.tip.time_s / (4 * half_s));
    const double arms = std::clamp((point.tip.time_s - 4 * half_s) / (10 * half_s), 0.0, 1.0);
    EXPECT_NEAR(point.joints.values[2], 1.5 * wheel, 1e-6);
    EXPECT_NEAR(point.joints.values[0], 5 * arms * 0.005, 1e-6);
    EXPECT_NEAR(point.joints.values[1], -3 * arms * 0.005, 1e-6);
    EXPECT_EQ(point.tip.mark.block.line, 1U);
  }
  EXPECT_EQ(sink.points.back().joints.values[0], 0.025);
}

TEST(PatternReplay, AnotherSpeedForEveryTripletKeepsThatOfTheWheel) {
  const auto definition = machine_with("arm4", {{"pattern.cut_speed", "78"}});
  const auto motors = *PatternMachine::of(definition);
  PatternReplay replay(motors);
  ASSERT_TRUE(replay.take(FastRecord{ArmAxis::theta1, {18000, false}}));
  const std::vector<std::pair<int, int>> moves = {{0, 30}, {20, 30}, {30, 0}, {-30, 30}};
  for (const auto& [theta1, theta2] : moves) {
    const double begin_s = replay.time_s();
    const TipPoint from = motors.tip_at(replay.counters());
    ASSERT_TRUE(replay.take(
        Triplet{{drive::pulse_field(0), drive::pulse_field(theta1), drive::pulse_field(theta2)},
                Triplet::kAxes}));
    const AxisVector way = motors.tip_at(replay.counters()) - from;
    const double speed = std::hypot(way.values[0], way.values[1]) / (replay.time_s() - begin_s);
    EXPECT_LE(speed, 1.3 * 1.001);
  }
}

TEST(PatternMachine, OnlyMachinesWithFourSuchMotors) {
  for (const char* const name : {"mill3", "mill4", "laser-xtz", "laser5"}) {
    const auto definition = machine_with(name);
    const auto motors = PatternMachine::of(definition);
    ASSERT_FALSE(motors) << name;
    EXPECT_EQ(motors.error().kind, base::Failure::Kind::usage);
  }
}

}  // namespace
}  // namespace kerf::engraver
