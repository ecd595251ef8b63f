// The control is ahead of the axes; what is kept belongs to the block that is made.
#include <cmath>
#include <functional>
#include <random>

#include "base/diagnostic.hpp"
#include "bench.hpp"
#include "lang/vm/value.hpp"

namespace kerf::test {
namespace {

constexpr std::size_t kFirstPermanent = 100;  // #500 among the commons

double kept(Bench& bench, int number = 500) {
  return bench->memory().commons[kFirstPermanent + static_cast<std::size_t>(number - 500)];
}

// Counters in every part of the permanent memory, one step for each block that moves.
constexpr const char* kCounters =
    "O1\n#500=0\n#3901=0\n#5221=0\n#7001=0\n#2001=0\nG90G94G10L10P2R0\nG10L2P2Y0\nG00X0\n"
    "WHILE[#500LT3000]DO1\n#500=#500+1\n#3901=#500\n#5221=#500/1000\n#7001=#500/1000\n"
    "#2001=#500/1000\nG90G10L10P2R[#500/1000]\nG10L2P2Y[#500/1000]\n#100=#500\n"
    "G91G01X[0.5-[#500AND1]]F6000\nEND1\nM30\n";

// All of them tell the same count.
void expect_count(const control::Memory& memory, double count) {
  EXPECT_EQ(memory.commons[kFirstPermanent], count);
  EXPECT_EQ(memory.parts, count);
  EXPECT_EQ(memory.work[0].values[0], count / 1000);
  EXPECT_EQ(memory.extended[0].values[0], count / 1000);
  EXPECT_EQ(memory.tools[1].length_wear, count / 1000);
  EXPECT_EQ(memory.tools[2].length_geometry, count / 1000);
  EXPECT_EQ(memory.work[1].values[1], count / 1000);
}

// Steps stop between the counters.
void expect_shown(Bench& bench) {
  const control::Memory memory = bench->memory();
  const auto same = [](double a, double b) { return a == b || (vm::is_null(a) && vm::is_null(b)); };
  EXPECT_TRUE(same(memory.commons[kFirstPermanent], bench.value("#500")));
  EXPECT_EQ(memory.parts, bench.value("#3901"));
  EXPECT_EQ(memory.work[0].values[0], bench.value("#5221"));
  EXPECT_EQ(memory.work[1].values[1], bench.value("#5242"));
  EXPECT_EQ(memory.extended[0].values[0], bench.value("#7001"));
  EXPECT_EQ(memory.tools[1].length_wear, bench.value("#2001"));
  EXPECT_EQ(memory.tools[2].length_geometry, bench.value("#2202"));
}

// Lets time pass in small steps until the axes rest; what the panel showed of #500 on the way last.
double shown_last(Bench& bench) {
  double shown = bench.value("#500");
  for (int i = 0; i < 20'000 && bench.status() == Status::running; ++i) {
    shown = bench.value("#500");
    bench->advance(0.001);
  }
  return shown;
}

TEST(ReadAhead, TheMemoryIsThatOfTheBlockThatIsMade) {
  Bench bench;
  bench.start(kCounters);
  double before = 0;
  for (int i = 0; i < 40; ++i) {
    bench->advance(0.05);
    const double shown = bench.value("#500");
    EXPECT_GE(shown, before);
    expect_count(bench->memory(), shown);
    EXPECT_EQ(bench.value("#3901"), shown);
    EXPECT_EQ(bench.value("#5221"), shown / 1000);
    before = shown;
  }
  EXPECT_GT(before, 10);
  EXPECT_LT(before, 2000);
}

TEST(ReadAhead, ResetGoesBackToWhatThePanelShowed) {
  Bench bench;
  bench.start(kCounters, 2);
  bench->perform(Reset{});
  const double shown = shown_last(bench);
  EXPECT_EQ(bench.status(), Status::idle);
  EXPECT_GT(shown, 10);
  EXPECT_LT(shown, 2000);
  EXPECT_EQ(bench.value("#500"), shown);
  expect_count(bench->memory(), shown);
  EXPECT_EQ(bench.now().work.values[0], bench.now().machine.values[0] - shown / 1000);
}

TEST(ReadAhead, ACounterBesideADwellCountsDwellsThatWereMade) {
  Bench bench;
  bench.load("O1\nWHILE[#500LT100000]DO1\n#500=#500+1\nG4P200\nEND1\nM30\n");
  EXPECT_DONE(bench->perform(SetVariable{"#500", 0}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(5.1);
  EXPECT_EQ(bench.value("#500"), 26);
  EXPECT_EQ(kept(bench), 26);
  bench->perform(Reset{});
  bench.settle();
  EXPECT_EQ(bench.value("#500"), 26);
  EXPECT_EQ(kept(bench), 26);
}

TEST(ReadAhead, AnAlarmOfADriveGoesBackToWhatThePanelShowed) {
  Bench bench;
  bench.start(kCounters, 2);
  const double shown = bench.value("#500");
  bench->perform(Raise{base::make_error(base::Code::timer_overflow, {}, "X")});
  bench->advance(0.01);
  ASSERT_EQ(bench.status(), Status::alarm);
  EXPECT_EQ(bench.value("#500"), shown);
  expect_count(bench->memory(), shown);
  bench->perform(Reset{});
  bench.settle();
  expect_count(bench->memory(), shown);
}

TEST(ReadAhead, AnAlarmOfTheProgramKeepsAllThatWasDoneBefore) {
  Bench bench;
  bench.start("O1\n#500=1\nG91G01X10.F6000\n#500=2\nG01X10.\n#500=3\n#3000=1(NO)\n");
  EXPECT_EQ(bench.settle(), Status::alarm);
  EXPECT_EQ(kept(bench), 3);
  bench->perform(Reset{});
  EXPECT_EQ(kept(bench), 3);
}

TEST(ReadAhead, StopsAndTheEndKeepAll) {
  Bench bench;
  bench.start("O1\nG91G01X10.F6000\n#500=2\nM00\n#500=3\nG01X10.\n#500=4\nM30\n");
  EXPECT_EQ(bench.settle(), Status::stopped);
  EXPECT_EQ(kept(bench), 2);
  EXPECT_DONE(bench->perform(SetVariable{"#501", 7}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(0.02);
  EXPECT_EQ(kept(bench), 3);
  EXPECT_EQ(kept(bench, 501), 7);
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(kept(bench), 4);
  EXPECT_EQ(bench->memory().parts, 1);
}

// Millions of writes and no motion between them.
TEST(ReadAhead, ALoopThatMovesNothingIsNotKeptBeforeTheMoveBehindItBegins) {
  Bench bench;
  EXPECT_DONE(bench->perform(SetVariable{"#500", 0}));
  bench.start("O1\nG91G01X10.F600\nWHILE[#500LT1000000]DO1\n#500=#500+1\nEND1\nG01X10.\nM30\n");
  for (int i = 0; i < 5; ++i) {
    bench->advance(0.1);
    EXPECT_EQ(bench.value("#500"), 0);
    EXPECT_EQ(kept(bench), 0);
  }
  bench->perform(Reset{});
  bench.settle();
  EXPECT_EQ(kept(bench), 0);
  bench.go_on_to_end();
  EXPECT_EQ(kept(bench), 1000000);
}

TEST(ReadAhead, WhatWasWrittenAtRestIsKeptWhileTheControlWaits) {
  Bench bench;
  bench.start("O1\nG91G01X1.F6000\n#500=5\n#1=#3001\nN1IF[#3001LT#1+60000]GOTO1\nG01X1.\nM30\n");
  for (int i = 0; i < 20; ++i) bench->advance(0.1);
  EXPECT_EQ(bench.status(), Status::running);
  EXPECT_EQ(bench.value("#500"), 5);
  EXPECT_EQ(kept(bench), 5);
  bench->perform(Reset{});
  bench.settle();
  EXPECT_EQ(kept(bench), 5);
}

TEST(ReadAhead, WhatTheOperatorEntersIsKeptFromTheFirstInstantOfTheNextMove) {
  Bench bench;
  EXPECT_DONE(bench->perform(SetMode{Mode::mdi}));
  EXPECT_DONE(bench->perform(EnterBlocks{"G91G01X1.F600\n#500=1"}));
  bench.settle();
  EXPECT_EQ(kept(bench), 1);
  EXPECT_DONE(bench->perform(SetVariable{"#501", 2}));
  EXPECT_DONE(bench->perform(SetOffset{"G54", "X", 3}));
  const auto all_kept = [&] {
    return kept(bench) == 1 && kept(bench, 501) == 2 && bench->memory().work[0].values[0] == 3;
  };
  EXPECT_DONE(bench->perform(EnterBlocks{"G91G01X1.F600"}));
  EXPECT_TRUE(all_kept());
  bench->advance(0.0001);
  EXPECT_TRUE(all_kept());
  bench->perform(Reset{});
  bench.settle();
  EXPECT_TRUE(all_kept());
  EXPECT_DONE(bench->perform(SetVariable{"#500", 1}));
  EXPECT_DONE(bench->perform(SetMode{Mode::jog}));
  EXPECT_DONE(bench->perform(Jog{"X", 600}));
  EXPECT_TRUE(all_kept());
  bench->advance(0.0001);
  EXPECT_TRUE(all_kept());
  bench->perform(Reset{});
  bench.settle();
  EXPECT_TRUE(all_kept());
}

TEST(ReadAhead, NamesOfVariablesGoBackToo) {
  Bench bench;
  bench.start("O1\nG91G01X100.F600\nSETVN510[AHEAD]\n#510=3\nG01X1.\nM30\n", 1);
  EXPECT_TRUE(bench->memory().names.empty());
  EXPECT_TRUE(vm::is_null(bench.value("#510")));
  bench->perform(Reset{});
  bench.settle();
  EXPECT_TRUE(bench->memory().names.empty());
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench.settle();
  EXPECT_EQ(bench->memory().names.count("AHEAD"), 1U);
}

TEST(ReadAhead, CommonsThatSurviveTheResetGoBackToo) {
  Bench bench("mill3", {}, {{"CCV", "1"}});
  bench.start("O1\n#100=1\nG91G01X100.F600\n#100=2\nG01X1.\nM30\n", 1);
  EXPECT_EQ(bench.value("#100"), 1);
  bench->perform(Reset{});
  bench.settle();
  EXPECT_EQ(bench.value("#100"), 1);
}

// What the operator has entered counts from then on, though no block has read it yet.
TEST(ReadAhead, WhatTheOperatorEntersInAHoldIsShownAtOnceAndStays) {
  Bench bench;
  bench.start("O1\n#500=1\n#501=1\nG91G01X100.F600\n#501=2\nG01X1.\n#500=3\nG01X1.\nM30\n", 1);
  bench.hold();
  EXPECT_DONE(bench->perform(SetVariable{"#500", 7}));
  EXPECT_DONE(bench->perform(SetVariable{"#502", 8}));
  EXPECT_DONE(bench->perform(SetVariable{"#500", 9}));
  EXPECT_DONE(bench->perform(SetVariable{"#1", 5}));
  EXPECT_EQ(bench.value("#500"), 9);
  EXPECT_EQ(bench.value("#502"), 8);
  EXPECT_EQ(bench.value("#1"), 5);
  EXPECT_EQ(bench.value("#501"), 1);
  EXPECT_EQ(kept(bench), 9);
  bench->perform(Reset{});
  bench.settle();
  EXPECT_EQ(kept(bench), 9);
  EXPECT_EQ(kept(bench, 502), 8);
  EXPECT_EQ(kept(bench, 501), 1);
}

TEST(ReadAhead, WhatTheProgramSetsBehindAnEntryCounts) {
  Bench bench;
  bench.start("O1\n#500=1\nG91G61G01X10.F600\n#501=#500\nG01X10.\n#500=3\nG01X10.\nM30\n", 0.5);
  bench.hold();
  EXPECT_DONE(bench->perform(SetVariable{"#500", 7}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(1);
  EXPECT_EQ(bench.value("#500"), 7);
  EXPECT_EQ(bench.value("#501"), 7);
  bench->advance(1);
  EXPECT_EQ(bench.value("#500"), 3);
  EXPECT_EQ(kept(bench), 3);
}

TEST(ReadAhead, AVariableOfBasicIsShownAsItWasEntered) {
  Bench bench("laser3");
  bench.load("speed(10)\na=1\nline(100,0)\na=2\nline(200,0)\nend\n", "a.bas", "laser-basic");
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(1);
  bench.hold();
  EXPECT_DONE(bench->perform(SetVariable{"A", 7}));
  EXPECT_EQ(bench.value("A"), 7);
}

TEST(ReadAhead, ASearchThatFindsNoLineChangesNoMemory) {
  Bench bench;
  bench.load("O1\n#500=1\nG10L2P1X5.\nG01X1.F600\nM30\nN9G01X2.\n");
  EXPECT_REFUSED(bench->perform(StartAt{6}), "before line 6 is reached");
  EXPECT_TRUE(vm::is_null(kept(bench)));
  EXPECT_EQ(bench->memory().work[0].values[0], 0);
}

// More changes ahead than the trail has entries for: what is kept is at most what was made.
TEST(ReadAhead, ShortLinesThatJoinInOneAreCountedAsTheyAreMade) {
  Bench bench;
  bench.start("O1\n#500=0\nG91G64\nWHILE[#500LT60000]DO1\n#500=#500+1\nG01X0.001F60\nEND1\nM30\n");
  for (int i = 0; i < 20; ++i) {
    bench->advance(0.25);
    const double made = std::round(bench.x() / 0.001);
    EXPECT_LE(kept(bench), made + 2);
    EXPECT_GE(kept(bench), made - 2);
  }
  bench->perform(Reset{});
  const double shown = shown_last(bench);
  EXPECT_EQ(kept(bench), shown);
  EXPECT_NEAR(shown, bench.x() / 0.001, 2);
}

// Whatever an operator does, the memory counts what the panel shows, and a reset changes nothing.
TEST(ReadAhead, AtAnyInstantOfAnyOperatorTheMemoryIsWhatThePanelShows) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto number = [&](int below) {
      return std::uniform_int_distribution<int>(0, below - 1)(random);
    };
    Bench bench;
    bench.load(kCounters);
    EXPECT_DONE(bench->perform(SetVariable{"#600", 0}));
    EXPECT_DONE(bench->perform(CycleStart{}));
    double entered = 0;
    for (int i = 0; i < 60; ++i) {
      switch (number(9)) {
        case 0: static_cast<void>(bench->perform(CycleStart{})); break;
        case 1: static_cast<void>(bench->perform(FeedHold{})); break;
        case 2:
          static_cast<void>(bench->perform(TurnSwitch{Switch::single_block, number(2) == 0}));
          break;
        case 3: static_cast<void>(bench->perform(SetDials{number(201), number(101), 100})); break;
        case 4: static_cast<void>(bench->perform(TakeStep{machine::Step::into})); break;
        case 5:
          if (number(4) != 0) break;
          bench->perform(Reset{});
          static_cast<void>(bench->perform(SetDials{100, 100, 100}));
          bench.settle(0.001);
          static_cast<void>(bench->perform(CycleStart{}));
          break;
        case 6:
          if (bench->perform(SetVariable{"#600", i})) entered = i;
          break;
        default: static_cast<void>(bench->perform(SetDials{100, 100, 100}));
      }
      EXPECT_EQ(kept(bench, 600), entered);
      bench->advance(number(200) / 1000.0);
      expect_shown(bench);
      EXPECT_EQ(bench.value("#600"), entered);
    }
    static_cast<void>(bench->perform(SetDials{100, 100, 100}));
    bench->perform(Reset{});
    const double shown = shown_last(bench);
    EXPECT_TRUE(kept(bench) == shown || vm::is_null(shown));
    EXPECT_EQ(kept(bench, 600), entered);
    expect_shown(bench);
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace kerf::test
