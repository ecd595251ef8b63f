// Steps, breakpoints, the call stack, variables by level, and the way back.
#include <algorithm>

#include "bench.hpp"
#include "lang/vm/value.hpp"

namespace kerf::test {
namespace {

using machine::Breakpoint;
using machine::Step;

// Lines:                     1   2          3            4           5    6   7     8      9     10
constexpr const char* kCalls =
    "O1\n#100=1\nG65P2A5.\nG91G00X1.\nM30\nO2\n#2=#1+1\n#100=#2\nX#2\nM99\n";

std::string stack_of(const machine::Snapshot& shown) {
  std::string text;
  for (const auto& level : shown.stack)
    text += level.program + ":" + std::to_string(level.line) + " ";
  return text;
}

Bench& stepped(Bench& bench, Step how) {
  EXPECT_DONE(bench->perform(TakeStep{how}));
  bench.settle();
  return bench;
}

TEST(Stepping, IntoGoesBlockByBlockThroughCalls) {
  Bench bench;
  bench.load(kCalls);
  std::vector<std::uint32_t> lines;
  for (int i = 0; i < 20 && bench.status() != Status::end; ++i) {
    stepped(bench, Step::into);
    if (bench.status() == Status::step) lines.push_back(bench.line());
  }
  EXPECT_EQ(lines, (std::vector<std::uint32_t>{2, 3, 7, 8, 9, 10, 4, 5}));
}

TEST(Stepping, OverStaysInTheProgramAndOutLeavesIt) {
  Bench bench;
  bench.load(kCalls);
  EXPECT_DONE(bench->perform(RunTo{"", 3}));
  EXPECT_EQ(bench.settle(), Status::step);
  EXPECT_EQ(bench.line(), 3U);
  stepped(bench, Step::over);
  EXPECT_EQ(bench.line(), 4U);
  EXPECT_EQ(bench.value("#100"), 6);

  Bench other;
  other.load(kCalls);
  EXPECT_DONE(other->perform(RunTo{"part.nc", 7}));
  EXPECT_EQ(other.settle(), Status::step);
  EXPECT_EQ(stack_of(other.now()), "O0001:3 O0002:7 ");
  EXPECT_EQ(other.value("#1"), 5);
  EXPECT_TRUE(vm::is_null(other.value("#1", 0)));
  stepped(other, Step::out);
  EXPECT_EQ(other.line(), 4U);
  EXPECT_EQ(stack_of(other.now()), "O0001:4 ");
}

TEST(Stepping, AxesRestBehindEachStep) {
  Bench bench;
  bench.load("O1\nG91G01X10.F600\nX10.\nX10.\nM30\n");
  EXPECT_DONE(bench->perform(RunTo{"", 3}));
  EXPECT_EQ(bench.settle(), Status::step);
  EXPECT_EQ(bench.x(), 10);
  EXPECT_EQ(bench.now().text, "X10.");
  stepped(bench, Step::over);
  EXPECT_EQ(bench.x(), 20);
  EXPECT_EQ(bench.line(), 4U);
}

TEST(Breakpoints, OfALineStopBeforeItEachTime) {
  Bench bench;
  bench.load("O1\n#100=0\nWHILE[#100LT3]DO1\n#100=#100+1\nEND1\nM30\n");
  EXPECT_DONE(bench->perform(SetBreakpoints{{{"", 4, "", ""}}}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  for (const double value : {0, 1, 2}) {
    EXPECT_EQ(bench.settle(), Status::step);
    EXPECT_EQ(bench.line(), 4U);
    EXPECT_EQ(bench.value("#100"), value);
    ASSERT_TRUE(bench.now().breakpoint);
    EXPECT_EQ(bench.now().breakpoint->breakpoint.line, 4U);
    EXPECT_DONE(bench->perform(CycleStart{}));
  }
  EXPECT_EQ(bench.settle(), Status::end);
}

TEST(Breakpoints, ConditionsAreInTheLanguageOfTheProgram) {
  Bench bench;
  bench.load("O1\n#1=0\nN1 #1=#1+1\nIF[#1LT9]GOTO1\nM30\n");
  EXPECT_DONE(bench->perform(SetBreakpoints{{{"", 3, "#1 GT 5", ""}}}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  EXPECT_EQ(bench.settle(), Status::step);
  EXPECT_EQ(bench.value("#1"), 6);
  EXPECT_REFUSED(bench->perform(SetBreakpoints{{{"", 3, "#1 >", ""}}}), "breakpoint in line 3");
  EXPECT_EQ(bench->breakpoints().size(), 1U);

  Bench basic("laser3", {.dialect = "laser-basic"});
  basic.load("a=0\n10 a=a+1\nIF a<9 THEN 10\nEND\n", "a.bas");
  EXPECT_REFUSED(basic->perform(SetBreakpoints{{{"", 2, "c>5", ""}}}), "no variable C");
  EXPECT_DONE(basic->perform(SetBreakpoints{{{"", 2, "a>5", ""}}}));
  EXPECT_DONE(basic->perform(CycleStart{}));
  EXPECT_EQ(basic.settle(), Status::step);
  EXPECT_EQ(basic.value("A"), 6);

  Bench teach("laser5", {.dialect = "teach"});
  teach.load("TEACH 1\nPOINT 1 0 0 0 0\nEND\n", "a.tch");
  EXPECT_REFUSED(teach->perform(SetBreakpoints{{{"", 2, "a>5", ""}}}), "no variables");
  EXPECT_DONE(teach->perform(SetBreakpoints{{{"", 3, "", ""}}}));
  EXPECT_DONE(teach->perform(CycleStart{}));
  EXPECT_EQ(teach.settle(), Status::step);
  EXPECT_EQ(teach.line(), 3U);
}

TEST(Breakpoints, AConditionWithoutAValueStopsAndSaysSo) {
  Bench bench;
  bench.load("O1\n#1=0\n#2=1\nM30\n");
  EXPECT_DONE(bench->perform(SetBreakpoints{{{"", 3, "1/#1 GT 5", ""}}}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  EXPECT_EQ(bench.settle(), Status::step);
  ASSERT_TRUE(bench.now().breakpoint);
  EXPECT_NE(bench.now().breakpoint->trouble, "");
  EXPECT_FALSE(bench.now().alarm);
}

TEST(Breakpoints, OfAVariableStopBehindTheBlockThatHasWrittenIt) {
  Bench bench;
  bench.load(kCalls);
  EXPECT_REFUSED(bench->perform(SetBreakpoints{{{"", 0, "", "COUNT"}}}), "no such variable");
  EXPECT_DONE(bench->perform(SetBreakpoints{{{"", 0, "", "#100"}}}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  EXPECT_EQ(bench.settle(), Status::step);
  ASSERT_TRUE(bench.now().breakpoint);
  EXPECT_EQ(bench.now().breakpoint->written_line, 2U);
  EXPECT_EQ(bench.now().breakpoint->after, 1);
  EXPECT_DONE(bench->perform(CycleStart{}));
  EXPECT_EQ(bench.settle(), Status::step);
  EXPECT_EQ(bench.now().breakpoint->written_line, 8U);
  EXPECT_EQ(bench.now().breakpoint->before, 1);
  EXPECT_EQ(bench.now().breakpoint->after, 6);
  bench.go_on_to_end();
}

TEST(Breakpoints, ALocalVariableIsThatOfItsLevel) {
  Bench bench;
  bench.load("O1\n#1=9\nG65P2A5.\n#1=10\nM30\nO2\n#3=1\nM99\n");
  EXPECT_DONE(bench->perform(SetBreakpoints{{{"", 0, "", "#1"}}}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  EXPECT_EQ(bench.settle(), Status::step);
  EXPECT_EQ(bench.now().breakpoint->after, 9);
  EXPECT_DONE(bench->perform(CycleStart{}));
  EXPECT_EQ(bench.settle(), Status::step);
  EXPECT_EQ(bench.now().breakpoint->after, 10);
}

TEST(Variables, AreMarkedThatChangedAndCanBeSet) {
  Bench bench;
  bench.load("O1\n#100=1\n#101=2\n#102=#101\nM30\n");
  EXPECT_DONE(bench->perform(RunTo{"", 3}));
  bench.settle();
  stepped(bench, Step::over);
  const auto changed = [&](const std::string& name) {
    const auto listing = bench->variables_named({name});
    return !listing.rows.empty() && listing.rows[0].changed;
  };
  EXPECT_FALSE(changed("#100"));
  EXPECT_TRUE(changed("#101"));
  const auto revision = bench.now().variables_revision;
  EXPECT_DONE(bench->perform(SetVariable{"#101", 20}));
  EXPECT_NE(bench.now().variables_revision, revision);
  EXPECT_REFUSED(bench->perform(SetVariable{"101", 20}), "'#NUMBER'");
  EXPECT_REFUSED(bench->perform(SetVariable{"#1", 20, 3}), "no such level");
  EXPECT_DONE(bench->perform(SetVariable{"#100", std::nullopt}));
  bench.go_on_to_end();
  EXPECT_EQ(bench.value("#102"), 20);
  EXPECT_TRUE(vm::is_null(bench->memory().commons[0]));
}

// Where a program stands, as text.
std::string state_of(Bench& bench) {
  const machine::Snapshot shown = bench.now();
  std::string text = std::to_string(shown.line) + " " + stack_of(shown);
  for (const double value : shown.machine.values) text += std::to_string(value) + " ";
  for (const std::string& code : shown.modal) text += code;
  for (const auto& row : bench->variables().rows) {
    if (!vm::is_null(row.value)) text += row.name + "=" + std::to_string(row.value) + " ";
  }
  return text;
}

TEST(StepBack, UndoesSteps) {
  Bench bench;
  bench.load(kCalls);
  std::vector<std::string> states;
  for (int i = 0; i < 8; ++i) states.push_back(state_of(stepped(bench, Step::into)));
  for (int i = 6; i >= 0; --i) {
    EXPECT_DONE(bench->perform(StepBack{}));
    EXPECT_EQ(bench.status(), Status::step);
    EXPECT_EQ(state_of(bench), states[static_cast<std::size_t>(i)]) << i;
  }
  EXPECT_REFUSED(bench->perform(StepBack{}), "at its beginning");
  for (int i = 1; i < 8; ++i)
    EXPECT_EQ(state_of(stepped(bench, Step::into)), states[static_cast<std::size_t>(i)]) << i;
}

TEST(StepBack, GoesBackFromAnAlarmAndFromTheEnd) {
  Bench bench;
  bench.start("O1\n#100=5\nG91G00X1.\n#100=#100/0\nM30\n");
  EXPECT_EQ(bench.settle(), Status::alarm);
  EXPECT_DONE(bench->perform(StepBack{}));
  EXPECT_EQ(bench.status(), Status::step);
  EXPECT_EQ(bench.line(), 4U);
  EXPECT_EQ(bench.x(), 1);
  EXPECT_DONE(bench->perform(StepBack{}));
  EXPECT_EQ(bench.line(), 3U);
  EXPECT_EQ(bench.x(), 0);
  EXPECT_DONE(bench->perform(CycleStart{}));
  EXPECT_EQ(bench.settle(), Status::alarm);
}

TEST(StepBack, KeepsWhatTheOperatorDidBefore) {
  Bench bench;
  bench.load("O1\n#100=1\n#101=#100\n#102=#101\nM30\n");
  EXPECT_DONE(bench->perform(RunTo{"", 3}));
  bench.settle();
  EXPECT_DONE(bench->perform(SetVariable{"#100", 7}));
  stepped(bench, Step::over);
  stepped(bench, Step::over);
  EXPECT_EQ(bench.value("#102"), 7);
  EXPECT_DONE(bench->perform(StepBack{}));
  EXPECT_EQ(bench.line(), 4U);
  EXPECT_EQ(bench.value("#101"), 7);
  bench.go_on_to_end();
  EXPECT_EQ(bench.value("#102"), 7);
}

// The control has read far ahead of the first move while it is made.
constexpr const char* kMacroOnTheWay =
    "O1\n#100=1\nG65P2A10.\n#100=2\nG65P2A20.\n#100=3\nM30\n"
    "O2\n#33=#1*2\nG91G01X10.F600\n#33=-1\nM99\n";

TEST(OnTheWay, VariablesAndCallsAreThoseOfTheMotion) {
  Bench bench;
  bench.start(kMacroOnTheWay);
  std::vector<std::uint64_t> revisions;
  for (const double a : {10.0, 20.0}) {
    for (int i = 0; i < 8; ++i) {
      bench->advance(0.1);
      EXPECT_EQ(bench.status(), Status::running);
      EXPECT_EQ(bench.value("#1"), a);
      EXPECT_EQ(bench.value("#33"), 2 * a);
      EXPECT_EQ(bench.value("#100"), a / 10);
      EXPECT_TRUE(vm::is_null(bench.value("#1", 0)));
      ASSERT_EQ(bench.now().stack.size(), 2U);
      EXPECT_EQ(bench.now().stack[0].line, a / 10 * 2 + 1);
      EXPECT_EQ(bench.now().stack[1].program, "O0002");
      EXPECT_EQ(bench.now().stack[1].line, 10U);
    }
    revisions.push_back(bench.now().variables_revision);
    bench->advance(0.2);
  }
  EXPECT_NE(revisions[0], revisions[1]);
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.value("#100"), 3);
}

TEST(OnTheWay, VariablesOfBasicAreThoseOfTheMotion) {
  Bench bench("laser3");
  bench.load("speed(10)\nfor i=1 to 3\nline(10*i,0)\nnext\nend\n", "a.bas", "laser-basic");
  EXPECT_DONE(bench->perform(CycleStart{}));
  for (const double i : {1.0, 2.0, 3.0}) {
    bench->advance(0.5);
    EXPECT_EQ(bench.value("I"), i);
    bench->advance(0.5);
  }
}

TEST(AnInstant, HasTheVariablesOfItsMotion) {
  Bench bench;
  bench.start(kMacroOnTheWay);
  EXPECT_EQ(bench.settle(), Status::end);
  const auto variable = [&](const std::string& name) {
    for (const auto& row : bench->variables_at_state().rows)
      if (row.name == name) return row.value;
    return -1.0;
  };
  for (const auto& [time_s, a] : {std::pair{0.5, 10.0}, {1.5, 20.0}, {0.7, 10.0}}) {
    ASSERT_TRUE(bench->state_at(time_s));
    EXPECT_EQ(variable("#1"), a) << time_s;
    EXPECT_EQ(variable("#33"), 2 * a) << time_s;
    EXPECT_EQ(variable("#100"), a / 10) << time_s;
  }
}

TEST(AnInstant, IsTheStateThatTheRunHadThen) {
  Bench bench;
  bench.start("O1\n#100=1\nG91G01X10.F600\n#100=2\n#1=#3001\nG00Y5.\nG04X1.\nX5.\nM30\n");
  struct Seen {
    double time_s;
    machine::Snapshot shown;
  };
  std::vector<Seen> seen;
  for (int i = 0; bench.status() == Status::running && i < 1000; ++i) {
    if (i == 20) {
      EXPECT_DONE(bench->perform(FeedHold{}));
    }
    bench->advance(0.037);
    if (bench.status() == Status::held) {
      EXPECT_DONE(bench->perform(CycleStart{}));
    }
    seen.push_back({bench.now().time_s, bench.now()});
  }
  EXPECT_EQ(bench.status(), Status::end);
  for (std::size_t i = 0; i < seen.size(); i += 3) {
    const auto then = bench->state_at(seen[i].time_s);
    ASSERT_TRUE(then);
    EXPECT_EQ((*then)->machine, seen[i].shown.machine) << seen[i].time_s;
    EXPECT_EQ((*then)->line, seen[i].shown.line) << seen[i].time_s;
    EXPECT_EQ((*then)->modal, seen[i].shown.modal) << seen[i].time_s;
  }
  EXPECT_FALSE(bench->state_at(-1));
}

TEST(AnInstant, ThatIsStillToComeIsThatOfTheProgramByItself) {
  Bench bench;
  bench.load("O1\n#100=1\nG91G01X10.F600\nM00\n#100=2\nX10.\nM00\n#100=3\nX10.\nM30\n");
  EXPECT_DONE(bench->perform(SetVariable{"#101", 7}));
  const auto x_at = [&](double time_s) {
    const auto then = bench->state_at(time_s);
    return then ? (*then)->machine.values[0] : -1;
  };
  const auto variable = [&](const std::string& name) {
    for (const auto& row : bench->variables_at_state().rows)
      if (row.name == name) return row.value;
    return -1.0;
  };
  // Before the start, held in the first cut, with another feed: at 10 mm/s X is 10 mm further each
  // second.
  for (int round = 0; round < 3; ++round) {
    EXPECT_NEAR(x_at(1.5), 15, 0.6) << round;
    EXPECT_EQ(variable("#100"), 2) << round;
    EXPECT_NEAR(x_at(2.5), 25, 1) << round;
    EXPECT_EQ(variable("#100"), 3) << round;
    EXPECT_EQ(variable("#101"), 7) << round;
    EXPECT_NEAR(x_at(1.2), 12, 0.6) << round;
    EXPECT_EQ(x_at(1e6), 30) << round;
    if (round == 0) {
      EXPECT_DONE(bench->perform(CycleStart{}));
      bench->advance(0.3);
      EXPECT_DONE(bench->perform(FeedHold{}));
      bench->advance(0.3);
      EXPECT_EQ(bench.status(), Status::held);
    } else {
      EXPECT_DONE(bench->perform(SetDials{50, 100, 100}));
    }
  }
}

TEST(AnInstant, OfAProgramThatOnlyStopsIsFound) {
  Bench bench;
  bench.load("O1\nN1M00\nGOTO1\n");
  EXPECT_TRUE(bench->state_at(10));
}

TEST(StartAt, RebuildsTheModesAndMovesNothingUntilCycleStart) {
  const std::string text =
      "O1\nT5M06\nS800M03\nG90G00X10.Y20.\nZ-5.\nG91G01X10.F300\nM00\nG90X50.\nG00Z0\nM30\n";
  Bench bench;
  bench.load(text);
  EXPECT_REFUSED(bench->perform(StartAt{99}), "ends before line 99");
  EXPECT_DONE(bench->perform(StartAt{8}));
  EXPECT_EQ(bench.status(), Status::step);
  EXPECT_EQ(bench.line(), 8U);
  EXPECT_EQ(bench.x(), 0);
  const auto modal = bench.now().modal;
  EXPECT_NE(std::find(modal.begin(), modal.end(), "G91"), modal.end());
  EXPECT_NE(std::find(modal.begin(), modal.end(), "G01"), modal.end());
  Points points;
  bench->add_point_sink(points);
  bench.go_on_to_end();
  EXPECT_EQ(bench.x(), 50);
  EXPECT_EQ(bench.now().tool, 5U);
  EXPECT_EQ(bench.now().spindle_rpm, 800);
  // Over the work first, then down: while Z is away from 0, X and Y have arrived.
  for (const auto& point : points.all) {
    if (point.tip.tip.values[2] >= 0) continue;
    EXPECT_GE(point.tip.tip.values[0], 20 - 1e-9);
    EXPECT_EQ(point.tip.tip.values[1], 20);
  }
}

TEST(StartAt, BringsTheAxesThereWithTheBeamOff) {
  for (const auto& [text, line] :
       {std::pair{"O1\nG90M03S500\nG01X10.F600\nX20.\nX30.\nX40.\nM30\n", 6U},
        std::pair{"power(50)\nspeed(10)\nline(10,0)\nline(20,0)\nline(30,0)\nline(40,0)\nend\n",
                  6U}}) {
    const bool basic = text[0] == 'p';
    Bench bench("laser3");
    bench.load(text, basic ? "part.bas" : "part.nc", basic ? "laser-basic" : "fanuc-mill");
    EXPECT_DONE(bench->perform(StartAt{line}));
    Points points;
    bench->add_point_sink(points);
    bench.go_on_to_end();
    ASSERT_FALSE(points.all.empty());
    for (const auto& point : points.all) {
      const bool there = point.tip.tip.values[0] > 30;
      EXPECT_EQ(point.power_percent, there ? 50 : 0) << text << point.tip.tip.values[0];
    }
  }
}

TEST(StartAt, TellsOfAnAlarmOnTheWay) {
  Bench bench;
  bench.load("O1\nG01X1.\nG00X5.\nM30\n");
  EXPECT_REFUSED(bench->perform(StartAt{3}), "before line 3 is reached");
}

// The control has read the block to step back to long before the switch was turned; the axes have
// obeyed it on their way there.
TEST(Stepping, AStepBackKeepsASwitchThatTheAxesHaveObeyed) {
  Bench bench;
  bench.start("O1\nG91G94G01X10.F600\n/Y1.\nX10.\n/Y1.\nM00\nM30\n", 1.5);
  EXPECT_DONE(bench->perform(SetBlockSkip{1U << 1U}));
  ASSERT_EQ(bench.settle(), Status::stopped);
  EXPECT_EQ(bench.now().machine.values[1], 1);  // the second slash was not begun
  EXPECT_DONE(bench->perform(StepBack{}));
  EXPECT_EQ(bench.now().machine.values[1], 1);
  EXPECT_EQ(bench.now().panel.skip_levels, 1U << 1U);
  const auto again = bench->state_at(bench.now().time_s);
  ASSERT_TRUE(again);
  EXPECT_EQ((*again)->panel.skip_levels, 1U << 1U);
  EXPECT_EQ((*again)->machine, bench.now().machine);
}

}  // namespace
}  // namespace kerf::test
