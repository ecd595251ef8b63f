// A pattern on the panel: the same pulses as `kerf pattern replay`, and what an operator can do on
// the way.
#include <cmath>

#include "machine/run/batch_run.hpp"
#include "pattern_bench.hpp"

namespace kerf::test {
namespace {

constexpr const char* kListing = "F Z 200\nF T2 4000\nS 0 12 -7\nS 3 30 30\nF Z -200\n";

TEST(PatternOnThePanel, MakesThePointsOfAReplay) {
  for (const char* const name : {"arm4", "cartesian-step"}) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
      SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(seed));
      const std::string listing = random_listing(seed, 40);
      Bench bench(name);
      Points live;
      bench->add_point_sink(live);
      with_pattern(bench, listing);
      EXPECT_DONE(bench->perform(CycleStart{}));
      ASSERT_EQ(bench.settle(0.001 * seed * seed), Status::end);
      Replayed replayed;
      replay(bench->definition(), listing, replayed);
      expect_same_points(live, replayed.points);
      EXPECT_NEAR(bench.now().time_s, replayed.time_s, 0.001 + 1e-9);
    }
  }
}

TEST(PatternOnThePanel, RunsWithoutPanelAsAReplayDoes) {
  const auto definition = *machine::find_machine("arm4");
  const std::string listing = random_listing(7, 60);
  machine::BatchRun batch(definition, control::Memory(definition.parameters.n_offsets),
                          {.dialect = "pattern"});
  Points points;
  batch.add_point_sink(points);
  batch.load(base::SourceFile::from_text("w.pat", listing));
  EXPECT_EQ(batch.run_to_end(), machine::RunStatus::end);
  Replayed replayed;
  replay(definition, listing, replayed);
  expect_same_points(points, replayed.points);
}

TEST(PatternOnThePanel, ShowsTheRecordThatItIsIn) {
  Bench bench("arm4");
  with_pattern(bench, kListing);
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(0.3);
  EXPECT_EQ(bench.line(), 1U);
  EXPECT_EQ(bench.now().text, "F Z 200");
  bench->advance(1);
  EXPECT_EQ(bench.now().text, "F T2 4000");
  EXPECT_EQ(bench.status(), Status::running);
}

TEST(PatternOnThePanel, StopsBehindEachRecordInSingleBlock) {
  Bench bench("arm4");
  with_pattern(bench, kListing);
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::single_block, true}));
  std::vector<std::string> passed;
  for (int i = 0; i < 5; ++i) {
    EXPECT_DONE(bench->perform(CycleStart{}));
    ASSERT_EQ(bench.settle(), Status::stopped);
    passed.push_back(bench.now().text);
  }
  EXPECT_EQ(passed, (std::vector<std::string>{"F Z 200", "F T2 4000", "S 0 12 -7", "S 3 30 30",
                                              "F Z -200"}));
  bench.go_on_to_end();
  Replayed replayed;
  replay(bench->definition(), kListing, replayed);
  EXPECT_EQ(bench.now().joints, replayed.points.all.back().joints);
}

TEST(PatternOnThePanel, SingleBlockSwitchedOnTheWayStopsBehindTheRecord) {
  Bench bench("arm4");
  with_pattern(bench, "S 0 30 0\nS 0 30 0\nS 0 30 0\nS 0 30 0\n");
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(0.4);
  EXPECT_EQ(bench.line(), 2U);
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::single_block, true}));
  ASSERT_EQ(bench.settle(), Status::stopped);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[0], 60 * 0.005);
  EXPECT_DONE(bench->perform(CycleStart{}));
  ASSERT_EQ(bench.settle(), Status::stopped);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[0], 90 * 0.005);
}

TEST(PatternOnThePanel, StepsAndRunsToALine) {
  Bench bench("arm4");
  with_pattern(bench, kListing);
  EXPECT_DONE(bench->perform(TakeStep{machine::Step::over}));
  ASSERT_EQ(bench.settle(), Status::step);
  EXPECT_EQ(bench.line(), 1U);
  EXPECT_DONE(bench->perform(TakeStep{machine::Step::over}));
  ASSERT_EQ(bench.settle(), Status::step);
  EXPECT_EQ(bench.line(), 2U);
  EXPECT_DONE(bench->perform(RunTo{"", 4}));
  ASSERT_EQ(bench.settle(), Status::step);
  EXPECT_EQ(bench.line(), 4U);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[1], (4000 - 7) * 0.005);
  EXPECT_DONE(bench->perform(StepBack{}));
  EXPECT_EQ(bench.line(), 3U);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[1], 4000 * 0.005);
  bench.go_on_to_end();
}

// 4000 pulses take 10 s; the ramp from 400 pulses/s needs 0.29 s.
TEST(PatternOnThePanel, AHoldCutsAFastRecordShortAndTheRestFollows) {
  Bench bench("arm4");
  with_pattern(bench, "F T2 4000\nS 0 1 1\n");
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(3);
  EXPECT_DONE(bench->perform(FeedHold{}));
  bench->advance(0.35);
  ASSERT_EQ(bench.status(), Status::held);
  const double pulses = bench.now().joints.values[1] * 200;
  EXPECT_NEAR(pulses, std::round(pulses), 1e-6) << "a motor rests on a whole pulse";
  EXPECT_GT(pulses, 1000);
  EXPECT_LT(pulses, 1400);
  bench->advance(5);
  EXPECT_EQ(bench.now().joints.values[1] * 200, pulses);
  EXPECT_DONE(bench->perform(CycleStart{}));
  ASSERT_EQ(bench.settle(), Status::end);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[1], 4001 * 0.005);
}

TEST(PatternOnThePanel, AHoldComesAtTheEndOfACut) {
  Bench bench("arm4");
  with_pattern(bench, "S 0 30 0\nS 0 30 0\n");
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(0.1);
  EXPECT_DONE(bench->perform(FeedHold{}));
  bench->advance(0.3);
  ASSERT_EQ(bench.status(), Status::held);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[0], 30 * 0.005);
  EXPECT_DONE(bench->perform(CycleStart{}));
  ASSERT_EQ(bench.settle(), Status::end);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[0], 60 * 0.005);
}

TEST(PatternOnThePanel, BeginsWhereEveryMotorStandsAtItsZero) {
  Bench bench("arm4");
  with_pattern(bench, kListing);
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(6);
  bench->perform(Reset{});
  bench->advance(2);
  ASSERT_EQ(bench.status(), Status::idle);
  EXPECT_REFUSED(bench->perform(CycleStart{}), "bring the axes to their reference points");
  EXPECT_DONE(bench->perform(SetMode{Mode::reference}));
  EXPECT_DONE(bench->perform(Home{}));
  ASSERT_NE(bench.settle(), Status::alarm);
  for (std::size_t joint = 0; joint < 4; ++joint)
    EXPECT_NEAR(bench.now().joints.values[joint], 0, 1e-5) << joint;
  EXPECT_DONE(bench->perform(SetMode{Mode::automatic}));
  Points again;
  bench->add_point_sink(again);
  bench.go_on_to_end();
  Replayed replayed;
  replay(bench->definition(), kListing, replayed);
  EXPECT_EQ(again.all.back().joints, replayed.points.all.back().joints);
}

// A stretched arm has no straight way of its tip: the motors go one by one, the lift first.
TEST(PatternOnThePanel, GoesHomeByItsMotors) {
  Bench bench("arm4");
  with_pattern(bench, "F T3 -26\nF T2 -4\nF Z -46\nS 0 1 1\n");
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::single_block, true}));
  for (int i = 0; i < 3; ++i) {
    EXPECT_DONE(bench->perform(CycleStart{}));
    ASSERT_EQ(bench.settle(), Status::stopped);
  }
  bench->perform(Reset{});
  bench->advance(1);
  EXPECT_DONE(bench->perform(SetMode{Mode::reference}));
  Points points;
  bench->add_point_sink(points);
  EXPECT_DONE(bench->perform(Home{}));
  ASSERT_NE(bench.settle(), Status::alarm);
  EXPECT_EQ(bench.now().joints, base::AxisVector{});
  EXPECT_EQ(bench.now().messages.back(), "all axes are at their reference points");
  for (const motion::AxisPoint& point : points.all) {
    if (point.joints.values[1] > -0.02 && point.joints.values[1] < 0) {
      EXPECT_DOUBLE_EQ(point.joints.values[3], 2);
    }
  }
  EXPECT_DONE(bench->perform(SetMode{Mode::automatic}));
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::single_block, false}));
  bench.go_on_to_end();
}

// A straight way that a stretched arm cannot go is no way to the reference points.
TEST(PatternOnThePanel, ReferencePointsThatAreNotReachedAreAnAlarm) {
  Bench bench("arm4");
  with_pattern(bench, "F T3 -26\nF T2 -4\nF Z -46\n");
  EXPECT_DONE(bench->perform(CycleStart{}));
  ASSERT_EQ(bench.settle(), Status::end);
  EXPECT_DONE(bench->perform(SetMode{Mode::jog}));
  EXPECT_DONE(bench->perform(JogBy{"Z", 0.1}));
  bench.settle();
  EXPECT_DONE(bench->perform(SetMode{Mode::reference}));
  EXPECT_DONE(bench->perform(Home{}));
  ASSERT_EQ(bench.settle(), Status::alarm);
  EXPECT_EQ(bench.now().alarm->code, "SINGULAR");
}

TEST(PatternOnThePanel, AxesAreMovedByHandBehindItAndNotWithinIt) {
  Bench bench("arm4");
  with_pattern(bench, "F T2 -2000\nF T1 4000\nF Z 300\n");
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::single_block, true}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  ASSERT_EQ(bench.settle(), Status::stopped);
  EXPECT_DONE(bench->perform(SetMode{Mode::jog}));
  EXPECT_REFUSED(bench->perform(JogBy{"Z", 1}), "counts its pulses on from here");
  EXPECT_DONE(bench->perform(SetMode{Mode::automatic}));
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::single_block, false}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  ASSERT_EQ(bench.settle(), Status::end);
  EXPECT_DONE(bench->perform(SetMode{Mode::jog}));
  EXPECT_DONE(bench->perform(JogBy{"Z", 1.5}));
  bench.settle();
  const machine::Snapshot shown = bench.now();
  EXPECT_NEAR(shown.joints.values[3], 4.5, 1e-9);
  EXPECT_NEAR(shown.joints.values[0], 20, 1e-9);
  EXPECT_NEAR(shown.joints.values[1], -10, 1e-9);
}

TEST(PatternOnThePanel, ARecordBeyondTheTravelIsAnAlarmBeforeItMoves) {
  Bench bench("arm4");
  with_pattern(bench, "F Z 200\nF Z 9801\nF Z -200\n");
  EXPECT_DONE(bench->perform(CycleStart{}));
  ASSERT_EQ(bench.settle(), Status::alarm);
  const auto alarm = bench.now().alarm;
  ASSERT_TRUE(alarm);
  EXPECT_EQ(alarm->code, "LIMIT");
  EXPECT_EQ(alarm->line, 2U);
  EXPECT_NE(alarm->message.find("Z goes to 100.01"), std::string::npos) << alarm->message;
  EXPECT_DOUBLE_EQ(bench.now().joints.values[3], 2);
}

TEST(PatternOnThePanel, AWrongLineIsAnAlarmWithItsPlace) {
  Bench bench("arm4");
  with_pattern(bench, "F Z 200\nF Q 3\n");
  const auto found = bench->check();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].place.line, 2U);
  EXPECT_DONE(bench->perform(CycleStart{}));
  ASSERT_EQ(bench.settle(), Status::alarm);
  EXPECT_EQ(bench.now().alarm->code, "PATTERN_TEXT");
  EXPECT_EQ(bench.now().alarm->line, 2U);
  EXPECT_EQ(bench.now().alarm->column, 3U);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[3], 2) << "what was before it is made";
}

TEST(PatternOnThePanel, ALineOfManyRecordsIsOneBlock) {
  Bench bench("arm4");
  with_pattern(bench, "S 0 9000 -3000\nF Z 1\n");
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::single_block, true}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  ASSERT_EQ(bench.settle(), Status::stopped);
  EXPECT_EQ(bench.line(), 1U);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[0], 45);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[1], -15);
  Bench endless("arm4");
  with_pattern(endless, "S 0 2147483647 0\n");
  EXPECT_DONE(endless->perform(CycleStart{}));
  ASSERT_EQ(endless.settle(), Status::alarm);
  EXPECT_EQ(endless.now().alarm->code, "PATTERN_TEXT");
}

TEST(PatternOnThePanel, IsNotForMachinesThatCountNoPulses) {
  for (const char* const name : {"mill3", "laser3", "laser5"}) {
    Bench bench(name);
    EXPECT_REFUSED(bench->perform(Load{base::ProgramText::of("w.pat", kListing), "pattern"}),
                   "has no controller for patterns");
    EXPECT_FALSE(bench->program());
  }
}

TEST(PatternOnThePanel, RecordsAreNoEntries) {
  Bench bench("arm4");
  with_pattern(bench, kListing);
  EXPECT_DONE(bench->perform(SetMode{Mode::mdi}));
  EXPECT_REFUSED(bench->perform(EnterBlocks{"F Z 200"}), "its records are no blocks to be entered");
}

TEST(PatternOnThePanel, TellsThatDialsDoNotChangeItsTimes) {
  Bench bench("arm4");
  with_pattern(bench, kListing);
  EXPECT_DONE(bench->perform(SetDials{50, 100, 100}));
  Points points;
  bench->add_point_sink(points);
  EXPECT_DONE(bench->perform(CycleStart{}));
  ASSERT_EQ(bench.now().messages.size(), 1U);
  EXPECT_NE(bench.now().messages[0].find("have their own times"), std::string::npos);
  EXPECT_EQ(bench.settle(), Status::end);
  Replayed replayed;
  replay(bench->definition(), kListing, replayed);
  expect_same_points(points, replayed.points);
}

TEST(PatternOnThePanel, ADialAtZeroHolds) {
  Bench bench("arm4");
  with_pattern(bench, "S 0 30 0\nS 0 30 0\n");
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(0.1);
  EXPECT_DONE(bench->perform(SetDials{0, 100, 100}));
  bench->advance(20);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[0], 30 * 0.005);
  EXPECT_DONE(bench->perform(SetDials{100, 100, 100}));
  EXPECT_EQ(bench.settle(), Status::end);
}

// The motors are brought to where the record begins, the lift clear of the work first.
TEST(PatternOnThePanel, StartsAtALine) {
  constexpr const char* listing = "F T2 400\nF T1 300\nS 5 30 -30\nS 0 30 30\nF Z 10\n";
  Bench bench("arm4");
  with_pattern(bench, listing);
  EXPECT_DONE(bench->perform(StartAt{4}));
  EXPECT_EQ(bench.line(), 4U);
  EXPECT_EQ(bench.now().joints, base::AxisVector{}) << "nothing moves before cycle start";
  Points points;
  bench->add_point_sink(points);
  EXPECT_DONE(bench->perform(CycleStart{}));
  ASSERT_EQ(bench.settle(), Status::end);
  Replayed replayed;
  replay(bench->definition(), listing, replayed);
  EXPECT_EQ(bench.now().joints, replayed.points.all.back().joints);
  double highest = 0;
  for (const motion::AxisPoint& point : points.all) {
    const bool arms_move = point.joints.values[0] != 0 && point.joints.values[0] < 1.6;
    if (arms_move) {
      EXPECT_DOUBLE_EQ(point.joints.values[3], 2);
    }
    highest = std::max(highest, point.joints.values[3]);
  }
  EXPECT_DOUBLE_EQ(highest, 2);
}

TEST(PatternOnThePanel, IsSeenAtAnyTimeOfItsRun) {
  Bench bench("arm4");
  const std::string listing = random_listing(3, 12);
  with_pattern(bench, listing);
  Replayed replayed;
  replay(bench->definition(), listing, replayed);
  const std::size_t middle = replayed.points.all.size() / 2;
  const motion::AxisPoint& expected = replayed.points.all[middle];
  const auto ahead = bench->state_at(expected.tip.time_s);
  ASSERT_TRUE(ahead);
  EXPECT_EQ((*ahead)->joints, expected.joints);
  EXPECT_EQ((*ahead)->line, expected.tip.mark.block.line);
  EXPECT_DONE(bench->perform(CycleStart{}));
  ASSERT_EQ(bench.settle(), Status::end);
  const auto back = bench->state_at(expected.tip.time_s);
  ASSERT_TRUE(back);
  EXPECT_EQ((*back)->joints, expected.joints);
}

TEST(PatternOnThePanel, ALockedMachineCountsAndStands) {
  Bench bench("arm4");
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::machine_lock, true}));
  with_pattern(bench, kListing);
  EXPECT_DONE(bench->perform(CycleStart{}));
  ASSERT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.now().joints, base::AxisVector{});
}

}  // namespace
}  // namespace kerf::test
