// The keys and switches of the panel, and the words with which they are refused.
#include <algorithm>
#include <cmath>
#include <functional>

#include "bench.hpp"

namespace kerf::test {
namespace {

constexpr const char* kLong = "O1\nG91G94G01X100.F600\nX100.\nM30\n";

TEST(Panel, CycleStartDoesNothingInModesThatRunNothing) {
  Bench bench;
  bench.load(kLong);
  for (const Mode mode : {Mode::edit, Mode::jog, Mode::reference, Mode::teach}) {
    EXPECT_DONE(bench->perform(SetMode{mode}));
    EXPECT_REFUSED(bench->perform(CycleStart{}), "turn the switch to auto");
  }
  EXPECT_DONE(bench->perform(SetMode{Mode::mdi}));
  EXPECT_REFUSED(bench->perform(CycleStart{}), "enter blocks");
  EXPECT_EQ(bench.status(), Status::idle);
}

TEST(Panel, CycleStartNeedsAProgramAndNoAlarm) {
  Bench bench;
  EXPECT_REFUSED(bench->perform(CycleStart{}), "no program is loaded");
  bench.start("O1\nG01X1.\nM30\n");
  EXPECT_EQ(bench.settle(), Status::alarm);
  EXPECT_REFUSED(bench->perform(CycleStart{}), "press reset first");
  ASSERT_TRUE(bench.now().alarm);
  EXPECT_EQ(bench.now().alarm->code, "PS0011");
  EXPECT_EQ(bench.now().alarm->line, 2U);
  EXPECT_FALSE(bench.now().alarm->cause.empty());
  bench->perform(Reset{});
  EXPECT_EQ(bench.status(), Status::idle);
  EXPECT_DONE(bench->perform(CycleStart{}));
}

TEST(Panel, WhileItRunsItRefusesWhatWouldDisturb) {
  Bench bench;
  bench.start(kLong, 1);
  EXPECT_EQ(bench.status(), Status::running);
  EXPECT_REFUSED(bench->perform(SetMode{Mode::jog}), "while the machine is running");
  EXPECT_REFUSED(bench->perform(CycleStart{}), "running");
  EXPECT_REFUSED(bench->perform(Load{base::ProgramText::of("b.nc", kLong)}), "busy");
  EXPECT_REFUSED(bench->perform(SetVariable{"#100", 1}), "while nothing moves");
  EXPECT_REFUSED(bench->perform(SetOffset{"G54", "X", 1}), "while nothing moves");
  EXPECT_REFUSED(bench->perform(TurnSwitch{Switch::dry_run, true}), "while nothing moves");
  EXPECT_REFUSED(bench->perform(TurnSwitch{Switch::machine_lock, true}), "between programs");
  EXPECT_REFUSED(bench->perform(TakeStep{machine::Step::over}), "hold first");
  EXPECT_REFUSED(bench->perform(RunTo{"", 3}), "hold first");
  EXPECT_REFUSED(bench->perform(StepBack{}), "running");
  EXPECT_REFUSED(bench->perform(StartAt{3}), "running");
  EXPECT_REFUSED(bench->perform(Jog{"X", 100}), "in mode jog");
  EXPECT_REFUSED(bench->perform(Home{}), "in mode ref");
  EXPECT_REFUSED(bench->perform(EnterBlocks{"X1."}), "in mode mdi");
  EXPECT_REFUSED(bench->perform(SetDials{201, 100, 100}), "0 to 200");
  EXPECT_REFUSED(bench->perform(SetDials{100, 101, 100}), "0 to 100");
  EXPECT_REFUSED(bench->perform(SetDials{100, 100, 49}), "50 to 120");
  EXPECT_REFUSED(bench->perform(SetBlockSkip{1}), "levels 1 to 9");
  bench.hold();
  EXPECT_REFUSED(bench->perform(SetMode{Mode::jog}), "go on with cycle start");
}

TEST(Panel, FeedHoldStopsOnTheWayAndCycleStartGoesOn) {
  Bench bench;
  bench.load(kLong);
  EXPECT_REFUSED(bench->perform(FeedHold{}), "nothing moves");
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(3);
  bench.hold();
  const double held = bench.x();
  EXPECT_GT(held, 25);
  EXPECT_LT(held, 35);
  EXPECT_EQ(bench.line(), 2U);
  bench->advance(5);
  EXPECT_EQ(bench.x(), held);
  EXPECT_EQ(bench.now().feed_actual_mm_min, 0);
  bench.go_on_to_end();
  EXPECT_EQ(bench.x(), 200);
}

// A point that was made but not reached yet is ahead of the axes.
TEST(Panel, WhoIsToldThatTheAxesAreHeldCanRelyOnTheirPlace) {
  constexpr double kPartOfAPeriod = 1e-4;
  const std::pair<const char*, const char*> runs[] = {{"mill3", kLong}, {"arm4", "F T2 4000\n"}};
  for (const auto& [name, program] : runs) {
    Bench bench(name);
    bench.load(program, program == kLong ? "part.nc" : "w.pat", program == kLong ? "" : "pattern");
    EXPECT_DONE(bench->perform(CycleStart{}));
    for (int i = 1; i < 20; ++i) {
      bench->advance(0.05 + i * kPartOfAPeriod / 2);
      EXPECT_DONE(bench->perform(FeedHold{}));
      ASSERT_EQ(bench.settle(kPartOfAPeriod), Status::held) << name;
      const base::JointPoint held = bench.now().joints;
      bench->advance(0.1);
      EXPECT_EQ(bench.now().joints, held) << name << " " << i;
      EXPECT_DONE(bench->perform(CycleStart{}));
    }
  }
}

// What an operator does who has not seen that the file is empty.
TEST(Panel, AFileWithoutBlocksHarmsNothingWhateverIsPressed) {
  using Act = std::function<void(Bench&)>;
  const std::vector<Act> acts = {
      [](Bench& bench) { static_cast<void>(bench->perform(CycleStart{})); },
      [](Bench& bench) { static_cast<void>(bench->perform(TakeStep{machine::Step::over})); },
      [](Bench& bench) { static_cast<void>(bench->perform(TakeStep{machine::Step::into})); },
      [](Bench& bench) { static_cast<void>(bench->perform(TakeStep{machine::Step::out})); },
      [](Bench& bench) { static_cast<void>(bench->perform(StepBack{})); },
      [](Bench& bench) {
        static_cast<void>(bench->perform(RunTo{"part.nc", 1}));
      },
      [](Bench& bench) { static_cast<void>(bench->perform(StartAt{1})); },
      [](Bench& bench) { static_cast<void>(bench->state_at(1)); }};
  for (const char* const text : {"", "\n", "%\n%\n", "(hi)\n", "' hi\n", "\1\2"}) {
    for (const char* const dialect : {"fanuc-mill", "laser-basic", "teach"}) {
      for (const Act& act : acts) {
        Bench bench("laser5");
        bench.load(text, "part.nc", dialect);
        act(bench);
        EXPECT_NE(bench.settle(), Status::running);
        bench->perform(Reset{});
        bench.load("O1\nG91G01X10.F600\nM30\n", "part.nc", "fanuc-mill");
        bench.go_on_to_end();
      }
    }
  }
}

TEST(Panel, AnEmptyFileSaysSoAtCycleStart) {
  Bench bench;
  bench.start("(hi)\n");
  EXPECT_EQ(bench.settle(), Status::alarm);
  ASSERT_TRUE(bench.now().alarm);
  EXPECT_EQ(bench.now().alarm->code, "EMPTY_PROGRAM");
  EXPECT_EQ(bench.now().program, "");
}

TEST(Panel, ADwellIsHeldAndTheRestOfItFollows) {
  Bench bench;
  bench.start("O1\nG04X10.\nG91G00X1.\nM30\n", 4);
  bench.hold();
  bench->advance(100);
  EXPECT_EQ(bench.x(), 0);
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(5.5);
  EXPECT_EQ(bench.x(), 0);
  bench->advance(2);
  EXPECT_EQ(bench.status(), Status::end);
  EXPECT_EQ(bench.x(), 1);
}

TEST(Panel, ResetStopsOnTheWayAndTheControlKnowsWhere) {
  Bench bench;
  bench.start(kLong, 3);
  bench->perform(Reset{});
  EXPECT_EQ(bench.settle(), Status::idle);
  const double at = bench.x();
  EXPECT_GT(at, 25);
  EXPECT_LT(at, 35);
  EXPECT_EQ(bench.now().work.values[0], at);
  bench.go_on_to_end();
  EXPECT_EQ(bench.x(), at + 200);
}

TEST(Panel, SingleBlockStopsBehindEachBlock) {
  Bench bench;
  bench.load("O1\nG91G00X1.\nX1.\nM30\n");
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::single_block, true}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  EXPECT_EQ(bench.settle(), Status::stopped);
  EXPECT_EQ(bench.x(), 1);
  EXPECT_DONE(bench->perform(CycleStart{}));
  EXPECT_EQ(bench.settle(), Status::stopped);
  EXPECT_EQ(bench.x(), 2);
  bench.go_on_to_end();
}

TEST(Panel, SingleBlockTurnedOnOnTheWayStopsBehindTheBlockUnderWay) {
  Bench bench;
  std::string blocks = "O1\nG91G94G64G01F600\n";
  for (int i = 0; i < 40; ++i) blocks += "X10.\n";
  bench.start(blocks + "M30\n", 5.5);
  const double before = bench.x();
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::single_block, true}));
  EXPECT_EQ(bench.settle(), Status::stopped);
  EXPECT_NEAR(bench.x(), 10 * std::ceil(before / 10), 1e-6);
  const double stopped = bench.x();
  for (int i = 1; i <= 3; ++i) {
    EXPECT_DONE(bench->perform(CycleStart{}));
    EXPECT_EQ(bench.settle(), Status::stopped);
    EXPECT_NEAR(bench.x(), stopped + 10 * i, 1e-6);
  }
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::single_block, false}));
  bench.go_on_to_end();
  EXPECT_EQ(bench.x(), 400);
}

TEST(Panel, SingleBlockInBasicStopsBehindEveryStatement) {
  Bench bench("laser3", {.dialect = "laser-basic"});
  bench.load("SPEED(10)\nMOVE(1,0)\nMOVE(2,0)\nMOVE(3,0)\nEND\n", "a.bas");
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::single_block, true}));
  for (const double x : {0, 1, 2, 3}) {
    EXPECT_DONE(bench->perform(CycleStart{}));
    EXPECT_EQ(bench.settle(), Status::stopped);
    EXPECT_EQ(bench.x(), x);
  }
  bench.go_on_to_end();
}

TEST(Panel, OptionalStopAndBlockSkipAreSwitches) {
  for (const bool on : {false, true}) {
    Bench bench;
    bench.load("O1\nG91G00X1.\nM01\n/X10.\nM30\n");
    EXPECT_DONE(bench->perform(TurnSwitch{Switch::optional_stop, on}));
    EXPECT_DONE(bench->perform(SetBlockSkip{on ? 2U : 0U}));
    EXPECT_DONE(bench->perform(CycleStart{}));
    if (on) {
      EXPECT_EQ(bench.settle(), Status::stopped);
      EXPECT_DONE(bench->perform(CycleStart{}));
    }
    EXPECT_EQ(bench.settle(), Status::end);
    EXPECT_EQ(bench.x(), on ? 1 : 11);
  }
}

TEST(Panel, DryRunGoesAtTheJogSpeed) {
  Bench bench("mill3", {.jog_mm_min = 3000});
  bench.load("O1\nG91G01X50.F60\nM30\n");
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::dry_run, true}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(0.5);
  EXPECT_NEAR(bench.now().feed_actual_mm_min, 3000, 1);
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_LT(bench.now().time_s, 2);
}

TEST(Panel, UnderMachineLockThePositionCountsAndTheAxesStand) {
  Bench bench;
  Points points;
  bench->add_point_sink(points);
  bench.load("O1\nG91G01X50.F6000\nM30\n");
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::machine_lock, true}));
  bench.go_on_to_end();
  EXPECT_EQ(bench.x(), 50);
  EXPECT_GT(points.all.size(), 100U);
  for (const auto& point : points.all) {
    EXPECT_EQ(point.tip.tip, base::AxisVector{});
    EXPECT_EQ(point.joints, base::AxisVector{});
  }
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::machine_lock, false}));
  EXPECT_EQ(bench.x(), 0);
}

TEST(Panel, TheFeedDialChangesTheFeedAndAtZeroHoldsCutsOnly) {
  Bench bench;
  bench.load("O1\nG91G00X50.\nG01X50.F600\nG00X50.\nM30\n");
  EXPECT_DONE(bench->perform(SetDials{0, 100, 100}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(60);
  EXPECT_EQ(bench.status(), Status::running);
  EXPECT_NEAR(bench.x(), 50, 1e-4);
  EXPECT_EQ(bench.now().feed_actual_mm_min, 0);
  EXPECT_DONE(bench->perform(SetDials{200, 100, 100}));
  bench->advance(1);
  EXPECT_NEAR(bench.now().feed_actual_mm_min, 1200, 1);
  EXPECT_DONE(bench->perform(SetDials{200, 0, 100}));
  bench->advance(60);
  EXPECT_NEAR(bench.x(), 100, 1e-2);
  EXPECT_DONE(bench->perform(SetDials{200, 100, 100}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.x(), 150);
}

TEST(Panel, TheSpindleDialIsInTheSpeedThatIsShown) {
  Bench bench;
  bench.load("O1\nM03S1000\nG91G00X1.\nM00\nM30\n");
  EXPECT_DONE(bench->perform(SetDials{100, 100, 120}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  EXPECT_EQ(bench.settle(), Status::stopped);
  EXPECT_EQ(bench.now().spindle_rpm, 1200);
  EXPECT_EQ(bench.now().spindle, motion::Spindle::Turning::clockwise);
}

TEST(Panel, MdiExecutesBlocksAndRemembersModesUntilReset) {
  Bench bench;
  EXPECT_DONE(bench->perform(SetMode{Mode::mdi}));
  EXPECT_REFUSED(bench->perform(EnterBlocks{" \n"}), "empty");
  EXPECT_DONE(bench->perform(EnterBlocks{"G91 G01 F6000\nX10."}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.x(), 10);
  EXPECT_DONE(bench->perform(EnterBlocks{"X5."}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.x(), 15);
  EXPECT_DONE(bench->perform(EnterBlocks{"#500=7 (NOTE)"}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.value("#500"), 7);
  bench->perform(Reset{});
  EXPECT_DONE(bench->perform(EnterBlocks{"X5."}));  // G90 G00 again
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.x(), 5);
  EXPECT_DONE(bench->perform(EnterBlocks{"G777"}));
  EXPECT_EQ(bench.settle(), Status::alarm);
}

TEST(Panel, ACycleAlongAShapeIsRefusedInMdi) {
  Bench bench("lathe2");
  EXPECT_DONE(bench->perform(SetMode{Mode::mdi}));
  EXPECT_DONE(bench->perform(EnterBlocks{"G71P10Q20F.2\nN10G00X10.\nN20G01Z-10."}));
  EXPECT_EQ(bench.settle(), Status::alarm);
  EXPECT_EQ(bench.now().alarm->code, "PS0067");
}

TEST(Panel, MdiOfBasicIsNotTheProgramThatIsLoaded) {
  Bench bench("laser3");
  bench.load("speed(40)\nmove(5, 5)\nline(500, 5)\nend\n", "wrong.bas", "laser-basic");
  EXPECT_DONE(bench->perform(CycleStart{}));
  EXPECT_EQ(bench.settle(), Status::alarm);
  bench->perform(Reset{});
  EXPECT_DONE(bench->perform(SetMode{Mode::mdi}));
  EXPECT_DONE(bench->perform(EnterBlocks{"speed(40); move(12.5, -7.5)"}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.x(), 12.5);
}

TEST(Panel, MdiIsRefusedWhileAProgramIsInterrupted) {
  Bench bench;
  bench.start("O1\nM00\nM30\n");
  EXPECT_EQ(bench.settle(), Status::stopped);
  EXPECT_DONE(bench->perform(SetMode{Mode::mdi}));
  EXPECT_REFUSED(bench->perform(EnterBlocks{"X1."}), "interrupted");
}

TEST(Panel, InputWaitsForALineOfTheOperator) {
  Bench bench("laser3", {.dialect = "laser-basic"});
  bench.load("INPUT A\nPRINT A+1\nEND\n", "a.bas");
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(10);
  EXPECT_EQ(bench.status(), Status::running);
  EXPECT_TRUE(bench.now().waits_for_input);
  EXPECT_DONE(bench->perform(EnterLine{"41"}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_NE(bench.now().printed.find("42"), std::string::npos);
}

TEST(Panel, AnEndlessLoopWithoutMotionLeavesThePanelAlive) {
  Bench bench;
  bench.start("O1\nN1 #100=#100+1\nGOTO1\n");
  for (int i = 0; i < 3; ++i) bench->advance(0.05);
  EXPECT_EQ(bench.status(), Status::running);
  bench->perform(Reset{});
  bench->advance(0.05);
  EXPECT_EQ(bench.status(), Status::idle);
}

TEST(Panel, OffsetsAndToolsAreEntered) {
  Bench bench;
  bench.load("O1\nG90G00G54X0\nG43H5Z0\nM30\n");
  EXPECT_DONE(bench->perform(SetOffset{"G54", "X", 12.5}));
  EXPECT_DONE(bench->perform(SetOffset{"tool.5.length_geometry", "", 30}));
  EXPECT_REFUSED(bench->perform(SetOffset{"G60", "X", 1}), "no offset");
  EXPECT_REFUSED(bench->perform(SetOffset{"G54", "Q", 1}), "no axis");
  EXPECT_REFUSED(bench->perform(SetOffset{"tool.5.colour", "", 1}), "no offset");
  bench.go_on_to_end();
  EXPECT_EQ(bench.x(), 12.5);
  EXPECT_EQ(bench.now().machine.values[2], 30);
  EXPECT_EQ(bench.now().work.values[0], 0);
}

TEST(Panel, AFurtherSystemIsToldWithItsNumber) {
  Bench bench;
  const auto shows = [&bench](const std::string& code) {
    const auto modal = bench.now().modal;
    return std::find(modal.begin(), modal.end(), code) != modal.end();
  };
  EXPECT_DONE(bench->perform(SetOffset{"G54.1 P3", "X", 7}));
  EXPECT_DONE(bench->perform(SetMode{Mode::mdi}));
  EXPECT_DONE(bench->perform(EnterBlocks{"G54.1 P3"}));
  bench.settle();
  EXPECT_TRUE(shows("G54.1 P3"));
  EXPECT_EQ(bench.now().work.values[0], -7);
  EXPECT_DONE(bench->perform(EnterBlocks{"G55"}));
  bench.settle();
  EXPECT_TRUE(shows("G55"));
  EXPECT_FALSE(shows("G54.1 P3"));
}

// A drive that cannot follow behind a place.
class Weak : public motion::AxisPointSink {
 public:
  explicit Weak(Bench& bench) : bench_(bench) {}
  void take(const motion::AxisPoint& point) override {
    at = point.joints;
    if (point.tip.tip.values[0] < 12 || raised) return;
    raised = true;
    bench_->perform(Raise{base::make_error(base::Code::step_rate, {}, "too fast")});
  }
  base::JointPoint at;
  bool raised = false;

 private:
  Bench& bench_;
};

TEST(Panel, AnAlarmOfADriveStopsTheAxesThereAndResetGoesOnFromThere) {
  Bench bench;
  Weak drive(bench);
  bench->add_point_sink(drive);
  bench.start("O1\nG91G94G01X10.F600\nX10.\nX10.\nM30\n");
  EXPECT_EQ(bench.settle(), Status::alarm);
  EXPECT_EQ(bench.now().alarm->code, "STEP_RATE");
  EXPECT_FALSE(bench.now().alarm->remedy.empty());
  EXPECT_EQ(bench.now().joints, drive.at);
  const double stopped = drive.at.values[0];
  EXPECT_NEAR(stopped, 12, 0.1);
  bench->perform(Reset{});
  EXPECT_EQ(bench.status(), Status::idle);
  EXPECT_EQ(bench.x(), stopped);
  bench.go_on_to_end();
  EXPECT_NEAR(bench.x(), stopped + 30, 1e-9);
}

TEST(Panel, MessagesAreToldOnce) {
  Bench bench;
  bench.start("O1\n#3006=1(LOOK)\nM00\nM30\n");
  EXPECT_EQ(bench.settle(), Status::stopped);
  EXPECT_EQ(bench.now().messages, std::vector<std::string>{"LOOK"});
  EXPECT_DONE(bench->perform(CycleStart{}));
  EXPECT_EQ(bench.settle(), Status::stopped);
  EXPECT_EQ(bench.now().messages, std::vector<std::string>{"LOOK"});
}

}  // namespace
}  // namespace kerf::test
