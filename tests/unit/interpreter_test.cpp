#include "lang/vm/interpreter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "page_builder.hpp"

namespace kerf::vm::test {
namespace {

using Stop = Interpreter::Stop;
using Events = std::vector<std::string>;

constexpr std::uint32_t kLocals = 10;
constexpr std::uint64_t kPlenty = 1'000'000;
constexpr double kMost = std::numeric_limits<double>::max();

// A program of one page, run to its end.
struct Machine {
  HandMadeSource source;
  RecordingHost host;
  std::vector<double> globals = std::vector<double>(5, kNull);
  Interpreter interpreter{source, host, {kLocals, globals, nullptr}};

  Stop run(PageBuilder page, std::uint64_t budget = kPlenty) {
    start(source.add(std::move(page)));
    return interpreter.run(budget);
  }
  void start(CodeId code) { interpreter.start(code); }
  double local(std::size_t n) { return interpreter.locals()[n]; }
};

std::string text(double value) { return is_null(value) ? "null" : std::to_string(value); }

// R[3] = R[1] op R[2], and the same with a constant; `wanted` null: the fault is wanted.
void expect_result(Op op, Op constant_op, double left, double right, double wanted, Fault fault) {
  for (const bool with_constant : {false, true}) {
    if (with_constant && constant_op == op) continue;
    Machine machine;
    PageBuilder page;
    page.load(1, left).load(2, right).load(3, 77);
    if (with_constant) {
      page.with_constant(constant_op, 3, 1, right);
    } else {
      page.three(op, 3, 1, 2);
    }
    EXPECT_EQ(machine.run(page.end()), Stop::over);
    const std::string what = text(left) + ", " + text(right) + " with operation " +
                             std::to_string(static_cast<int>(op)) +
                             (with_constant ? " and a constant" : "");
    EXPECT_EQ(machine.host.last_fault, fault) << what;
    EXPECT_EQ(machine.local(3), fault == Fault::none ? wanted : 77) << what;
  }
}

TEST(Interpreter, ArithmeticReadsNullAsZero) {
  const double values[] = {kNull, 0, 3, -2.5, 1e300};
  for (const double a : values) {
    for (const double b : values) {
      const double x = zero_if_null(a);
      const double y = zero_if_null(b);
      expect_result(Op::add, Op::add_constant, a, b, x + y, Fault::none);
      expect_result(Op::subtract, Op::subtract_constant, a, b, x - y, Fault::none);
      const bool too_large = std::isinf(x * y);
      expect_result(Op::multiply, Op::multiply_constant, a, b, x * y,
                    too_large ? Fault::overflow : Fault::none);
      expect_result(Op::divide, Op::divide_constant, a, b, y == 0 ? 0 : x / y,
                    y == 0 ? Fault::zero_divide : Fault::none);
    }
  }
}

TEST(Interpreter, AResultThatNoDoubleHoldsIsAnOverflow) {
  expect_result(Op::add, Op::add_constant, kMost, kMost, 0, Fault::overflow);
  expect_result(Op::subtract, Op::subtract_constant, -kMost, kMost, 0, Fault::overflow);
  expect_result(Op::multiply, Op::multiply_constant, 1e200, -1e200, 0, Fault::overflow);
  expect_result(Op::divide, Op::divide_constant, 1e300, 1e-300, 0, Fault::overflow);
}

TEST(Interpreter, TheNegativeOfNullIsZero) {
  Machine machine;
  machine.run(PageBuilder().load(1, kNull).three(Op::negate, 2, 1, 0).end());
  EXPECT_EQ(machine.local(2), 0);
}

TEST(Interpreter, ACopyOfNullIsNull) {
  Machine machine;
  machine.run(
      PageBuilder().load(1, 5).add({.op = Op::load_null, .a = 2}).three(Op::move, 1, 2, 0).end());
  EXPECT_TRUE(is_null(machine.local(1)));
}

TEST(Interpreter, NullEqualsOnlyNullButIsOrderedAsZero) {
  struct Case {
    double a, b;
    bool equal, less;
  };
  for (const Case& c :
       {Case{kNull, kNull, true, false}, Case{kNull, 0, false, false}, Case{0, kNull, false, false},
        Case{kNull, 1, false, true}, Case{kNull, -1, false, false}, Case{-1, kNull, false, true},
        Case{2, 2, true, false}, Case{1, 2, false, true}, Case{2, 1, false, false},
        Case{0, -0.0, true, false}}) {
    const double a = zero_if_null(c.a);
    const double b = zero_if_null(c.b);
    const std::pair<Op, bool> wanted[] = {{Op::equal, c.equal}, {Op::not_equal, !c.equal},
                                          {Op::less, c.less},   {Op::less_equal, a <= b},
                                          {Op::greater, a > b}, {Op::greater_equal, a >= b}};
    for (const auto& [op, truth] : wanted)
      expect_result(op, op, c.a, c.b, truth ? 1 : 0, Fault::none);
  }
}

TEST(Interpreter, BranchesGoWhereTheComparisonsSay) {
  const std::pair<Op, Op> pairs[] = {
      {Op::branch_equal, Op::equal},     {Op::branch_not_equal, Op::not_equal},
      {Op::branch_less, Op::less},       {Op::branch_less_equal, Op::less_equal},
      {Op::branch_greater, Op::greater}, {Op::branch_greater_equal, Op::greater_equal}};
  for (const auto& [branch, compare] : pairs) {
    for (const double a : {kNull, 0.0, 1.0}) {
      for (const double b : {kNull, 0.0, 1.0}) {
        for (const bool sense : {false, true}) {
          Machine machine;
          PageBuilder page;
          page.load(1, a).load(2, b).load(4, 1).three(compare, 3, 1, 2);
          page.add({branch, static_cast<std::uint8_t>(sense), 1, 2, 6}).load(4, 0).end();
          machine.run(page);
          const bool taken = machine.local(4) == 1;
          EXPECT_EQ(taken, (machine.local(3) != 0) == sense)
              << text(a) << ", " << text(b) << ", branch " << static_cast<int>(branch);
        }
      }
    }
  }
}

TEST(Interpreter, ATruthValueIsWhatIsNeitherZeroNorNull) {
  for (const double value : {kNull, 0.0, -0.0, 1.0, -3.0}) {
    Machine machine;
    PageBuilder page;
    page.load(1, value).load(2, 1).add({Op::branch, 1, 1, 0, 4}).load(2, 0).end();
    machine.run(page);
    EXPECT_EQ(machine.local(2), value == 0 || is_null(value) ? 0 : 1) << text(value);
  }
}

TEST(Interpreter, GlobalsLieInTheStorageOfTheCaller) {
  Machine machine;
  machine.globals[2] = 7;
  machine.run(PageBuilder()
                  .add({.op = Op::load_global, .a = 1, .n = 2})
                  .add({.op = Op::store_global, .a = 1, .n = 4})
                  .end());
  EXPECT_EQ(machine.local(1), 7);
  EXPECT_EQ(machine.globals[4], 7);
  EXPECT_TRUE(is_null(machine.globals[3]));
}

TEST(Interpreter, OtherVariablesAreTheHosts) {
  Machine machine;
  machine.host.variables[50] = 5;
  machine.run(PageBuilder()
                  .load(1, 50)
                  .three(Op::read, 2, 1, 0)
                  .add({.op = Op::read_fixed, .a = 3, .n = 51})
                  .load(4, 60)
                  .three(Op::write, 4, 2, 0)
                  .add({.op = Op::write_fixed, .a = 2, .n = 61})
                  .end());
  EXPECT_EQ(machine.host.events, (Events{"read 50", "read 51", "write 60", "write 61", "end"}));
  EXPECT_EQ(machine.local(2), 5);
  EXPECT_TRUE(is_null(machine.local(3)));
  EXPECT_EQ(machine.host.variables[60], 5);
  EXPECT_EQ(machine.host.variables[61], 5);
}

TEST(Interpreter, AVariableThatCannotBeReadEndsTheProgramAtThatInstruction) {
  Machine machine;
  machine.host.readable = false;
  EXPECT_EQ(machine.run(PageBuilder().load(1, 3).three(Op::read, 2, 1, 0).block(0).end()),
            Stop::over);
  EXPECT_EQ(machine.host.events, Events{"read 3"});
  EXPECT_EQ(machine.interpreter.place().line, 2U);
}

TEST(Interpreter, AWriteThatPausesGoesOnBehindIt) {
  Machine machine;
  machine.host.on_write = [](double) { return Verdict::pause; };
  PageBuilder page;
  page.add({.op = Op::write_fixed, .a = 1, .n = 9}).block(1).end();
  EXPECT_EQ(machine.run(page), Stop::paused);
  EXPECT_EQ(machine.interpreter.run(kPlenty), Stop::over);
  EXPECT_EQ(machine.host.events, (Events{"write 9", "block 1", "end"}));
}

TEST(Interpreter, EveryFaultNamesItsInstruction) {
  Machine machine;
  machine.run(PageBuilder().load(1, 1).load(2, 0).three(Op::divide, 3, 1, 2).block(0).end());
  EXPECT_EQ(machine.host.events.size(), 1U) << "the program went on behind the fault";
  const base::Place place = machine.interpreter.place();
  EXPECT_EQ(place.line, 3U);
  EXPECT_EQ(place.column, 3U);
  EXPECT_EQ(place.length, 3U);
}

TEST(Interpreter, AFailureOfTheTextIsHandedToTheHostWhenItIsReached) {
  Machine machine;
  PageBuilder page;
  base::Diagnostic diagnostic;
  diagnostic.message = "wrong";
  page.page().failures = {base::Diagnostic{}, diagnostic};
  EXPECT_EQ(machine.run(page.block(0).add({.op = Op::fail, .n = 1}).block(1).end()), Stop::over);
  EXPECT_EQ(machine.host.events, (Events{"block 0", "failure wrong"}));
}

TEST(Interpreter, ABuiltinTakesItsArgumentsAndMayFail) {
  static constexpr Builtin kTable[] = {
      {[](const double* r, BuiltinContext&) { return r[0] * 10 + zero_if_null(r[1]); }, 2},
      {[](const double*, BuiltinContext& context) {
         context.fault = Fault::domain;
         return 0.0;
       },
       0},
      {[](const double*, BuiltinContext&) { return std::nan(""); }, 0}};
  const auto call = [&](std::uint32_t n) {
    Machine machine;
    PageBuilder page;
    page.page().builtins = kTable;
    page.load(2, 4).load(3, kNull).load(5, 77).add({Op::call_builtin, 5, 2, 0, n});
    machine.run(page.end());
    return std::pair(machine.local(5), machine.host.last_fault);
  };
  EXPECT_EQ(call(0), std::pair(40.0, Fault::none));
  EXPECT_EQ(call(1), std::pair(77.0, Fault::domain));
  EXPECT_EQ(call(2), std::pair(77.0, Fault::overflow)) << "a function made a null";
}

// Calls

TEST(Interpreter, AFreshCallHasItsOwnLocalsAllNull) {
  Machine machine;
  const CodeId callee = machine.source.add(PageBuilder().block(1).load(1, 5).block(2).end());
  const CodeId caller = machine.source.add(PageBuilder().load(1, 3).block(0).block(3).end());
  machine.host.on_block = [&](std::uint32_t n) {
    if (n == 0) {
      machine.interpreter.call(callee, Interpreter::Locals::fresh);
      return Verdict::transferred;
    }
    if (n == 1) {
      EXPECT_TRUE(is_null(machine.local(1))) << "of the called program";
    }
    if (n != 2) return Verdict::go_on;
    EXPECT_EQ(machine.interpreter.depth(), 2U);
    machine.interpreter.return_to_caller();
    return Verdict::transferred;
  };
  machine.start(caller);
  EXPECT_EQ(machine.interpreter.run(kPlenty), Stop::over);
  EXPECT_EQ(machine.host.events, (Events{"block 0", "block 1", "block 2", "block 3", "end"}));
  EXPECT_EQ(machine.local(1), 3) << "of the caller";
}

TEST(Interpreter, ASharedCallSeesAndChangesTheLocalsOfItsCaller) {
  Machine machine;
  const CodeId callee =
      machine.source.add(PageBuilder().with_constant(Op::add_constant, 1, 1, 1).block(1).end());
  const CodeId caller = machine.source.add(PageBuilder().load(1, 3).block(0).end());
  machine.host.on_block = [&](std::uint32_t n) {
    if (n == 0) {
      machine.interpreter.call(callee, Interpreter::Locals::shared);
    } else {
      machine.interpreter.return_to_caller();
    }
    return Verdict::transferred;
  };
  machine.start(caller);
  machine.interpreter.run(kPlenty);
  EXPECT_EQ(machine.local(1), 4);
}

TEST(Interpreter, AThousandCallsDeepReturnToTheirOwnLocals) {
  Machine machine;
  PageBuilder page;
  page.add({.op = Op::load_global, .a = 1, .n = 0}).block(0);
  page.add({.op = Op::store_global, .a = 1, .n = 1}).block(1).end();
  const CodeId code = machine.source.add(page);
  double deepest = 0;
  std::vector<double> seen;
  machine.host.on_block = [&](std::uint32_t n) {
    if (n == 0 && deepest < 1000) {
      machine.globals[0] = ++deepest;
      machine.interpreter.call(code, Interpreter::Locals::fresh);
      return Verdict::transferred;
    }
    if (n == 0) return Verdict::go_on;
    seen.push_back(machine.globals[1]);
    if (machine.interpreter.depth() == 1) return Verdict::stop;
    machine.interpreter.return_to_caller();
    return Verdict::transferred;
  };
  machine.globals[0] = 0;
  machine.start(code);
  machine.interpreter.run(kPlenty);
  ASSERT_EQ(seen.size(), 1001U);
  for (std::size_t i = 0; i < seen.size(); ++i)
    EXPECT_EQ(seen[i], 1000 - static_cast<double>(i)) << "return number " << i;
}

TEST(Interpreter, ARestartKeepsTheRegisters) {
  Machine machine;
  PageBuilder page;
  page.with_constant(Op::add_constant, 1, 1, 1).block(0).end();
  machine.host.on_block = [&](std::uint32_t) {
    if (machine.local(1) == 3) return Verdict::go_on;
    machine.interpreter.restart();
    return Verdict::transferred;
  };
  machine.run(page);
  EXPECT_EQ(machine.local(1), 3);
}

TEST(Interpreter, AStartForgetsEverythingButTheGlobals) {
  Machine machine;
  const CodeId code = machine.source.add(PageBuilder().block(0).load(1, 5).end());
  machine.start(code);
  machine.interpreter.run(kPlenty);
  EXPECT_EQ(machine.local(1), 5);
  machine.globals[0] = 6;
  machine.start(code);
  EXPECT_TRUE(is_null(machine.local(1)));
  EXPECT_EQ(machine.globals[0], 6);
}

// Regions: 0 set; 1 enter; 2 test; 3 block; 4 count; 5 jump; 6 end of region

PageBuilder loop(double passes, const Region& region) {
  PageBuilder page;
  page.region(region);
  page.load(1, 0);                                        // 0
  page.load(2, passes);                                   // 1
  page.three(Op::less, 3, 1, 2);                          // 2: head
  page.add({Op::branch, 1, 3, 0, 5});                     // 3
  page.add({.op = Op::leave_region, .n = 0});             // 4
  page.add({.op = Op::enter_region, .n = 0});             // 5
  page.with_constant(Op::add_constant, 1, 1, 1);          // 6
  page.block(7);                                          // 7
  page.add({.op = Op::repeat_region, .a = region.slot});  // 8
  page.block(9).end();                                    // 9
  return page;
}

Region closed_region() {
  return {.slot = 2, .state = Region::State::closed, .head = 2, .end = {0, 8}};
}

TEST(Interpreter, ARegionRepeatsFromItsEndUntilItIsLeft) {
  Machine machine;
  EXPECT_EQ(machine.run(loop(3, closed_region())), Stop::over);
  EXPECT_EQ(machine.host.events, (Events{"block 7", "block 7", "block 7", "block 9", "end"}));
}

TEST(Interpreter, ARegionThatIsLeftAtOnceDoesNotRun) {
  Machine machine;
  machine.run(loop(0, closed_region()));
  EXPECT_EQ(machine.host.events, (Events{"block 9", "end"}));
}

TEST(Interpreter, ARegionIsResolvedOnceWhenItIsReached) {
  Machine machine;
  Region region = closed_region();
  machine.source.resolves_to(region);
  region.state = Region::State::unresolved;
  machine.run(loop(50, region));
  EXPECT_EQ(machine.source.region_searches, 1);
  EXPECT_EQ(machine.host.events.size(), 52U);
}

TEST(Interpreter, ARegionWithoutEndOrThatCrossesAnotherFaultsAtItsHead) {
  for (const auto& [state, fault] : {std::pair(Region::State::open, Fault::region_open),
                                     std::pair(Region::State::crossing, Fault::region_crossing)}) {
    Machine machine;
    Region region = closed_region();
    region.state = state;
    machine.run(loop(3, region));
    EXPECT_EQ(machine.host.last_fault, fault);
    EXPECT_EQ(machine.interpreter.place().line, 6U);
  }
}

TEST(Interpreter, AnEndWhoseHeadWasNotPassedFaults) {
  Machine machine;
  PageBuilder page;
  page.region(closed_region());
  for (int i = 0; i < 7; ++i) page.block(static_cast<std::uint32_t>(i));
  page.jump(8).add({.op = Op::repeat_region, .a = 2}).end();
  machine.run(page);
  EXPECT_EQ(machine.host.last_fault, Fault::region_not_entered);
  EXPECT_EQ(machine.interpreter.place().line, 9U);
}

TEST(Interpreter, AJumpOutOfARegionEndsItAndOneInsideDoesNot) {
  for (const bool outside : {false, true}) {
    Machine machine;
    bool jumped = false;
    machine.host.on_block = [&](std::uint32_t n) {
      if (n != 7 || jumped) return Verdict::go_on;
      jumped = true;
      machine.interpreter.jump({0, outside ? 1U : 6U});  // before the head, or inside
      if (outside) machine.interpreter.jump({0, 6});     // and back in
      return Verdict::transferred;
    };
    machine.run(loop(3, closed_region()));
    EXPECT_EQ(machine.host.last_fault, outside ? Fault::region_not_entered : Fault::none);
  }
}

TEST(Interpreter, ACalledProgramHasRegionsOfItsOwn) {
  Machine machine;
  const CodeId callee =
      machine.source.add(PageBuilder().add({.op = Op::repeat_region, .a = 2}).end());
  machine.host.on_block = [&](std::uint32_t) {
    machine.interpreter.call(callee, Interpreter::Locals::shared);
    return Verdict::transferred;
  };
  machine.run(loop(3, closed_region()));
  EXPECT_EQ(machine.host.last_fault, Fault::region_not_entered);
}

// Labels

TEST(Interpreter, AJumpGoesToTheNextBlockWithTheLabelOrElseTheFirst) {
  Machine machine;
  const CodeId code = machine.source.add(
      PageBuilder().block(0).to_label(5).block(1).block(2).to_label(6).block(3).end());
  machine.source.label(code, 5, {0, 0});
  machine.source.label(code, 5, {0, 3});
  machine.source.label(code, 6, {0, 5});
  machine.start(code);
  machine.interpreter.run(kPlenty);
  EXPECT_EQ(machine.host.events, (Events{"block 0", "block 2", "block 3", "end"}));
}

TEST(Interpreter, ALabelIsSearchedOncePerJumpHoweverOftenItIsTaken) {
  Machine machine;
  PageBuilder page;
  page.with_constant(Op::add_constant, 1, 1, 1).load(2, 1000).three(Op::less, 3, 1, 2);
  page.add({Op::branch, 0, 3, 0, 5}).to_label(1).end();
  const CodeId code = machine.source.add(page);
  machine.source.label(code, 1, {0, 0});
  machine.start(code);
  machine.interpreter.run(kPlenty);
  EXPECT_EQ(machine.local(1), 1000);
  EXPECT_EQ(machine.source.label_searches, 1);
}

TEST(Interpreter, ThousandsOfJumpsThatShareTheCacheStillGoToTheirOwnLabels) {
  constexpr std::uint32_t kJumps = 5000;
  Machine machine;
  PageBuilder page;
  for (std::uint32_t i = 0; i < kJumps; ++i) page.to_label(i + 1).block(99).block(i);
  const CodeId code = machine.source.add(page.end());
  for (std::uint32_t i = 0; i < kJumps; ++i) machine.source.label(code, i + 1, {0, 3 * i + 2});
  for (int pass = 0; pass < 2; ++pass) {
    machine.host.events.clear();
    machine.start(code);
    machine.interpreter.run(kPlenty);
    ASSERT_EQ(machine.host.events.size(), kJumps + 1);
    for (std::uint32_t i = 0; i < kJumps; ++i)
      ASSERT_EQ(machine.host.events[i], "block " + std::to_string(i));
  }
}

TEST(Interpreter, JumpsOfTwoProgramsAtTheSamePlaceDoNotMix) {
  Machine machine;
  const CodeId one = machine.source.add(PageBuilder().to_label(1).block(0).block(1).end());
  const CodeId two = machine.source.add(PageBuilder().to_label(1).block(2).block(3).end());
  machine.source.label(one, 1, {0, 1});
  machine.source.label(two, 1, {0, 2});
  machine.host.on_block = [&](std::uint32_t n) {
    if (n != 1) return Verdict::go_on;
    machine.interpreter.call(two, Interpreter::Locals::shared);
    return Verdict::transferred;
  };
  machine.start(one);
  machine.interpreter.run(kPlenty);
  EXPECT_EQ(machine.host.events, (Events{"block 0", "block 1", "block 3", "end"}));
}

TEST(Interpreter, ALabelThatDoesNotExistIsMissingWhateverItsNumber) {
  for (const std::uint32_t label : {0U, 1U, 99999999U, 4294967295U}) {
    Machine machine;
    machine.run(PageBuilder().block(0).to_label(label).end());
    EXPECT_EQ(machine.host.last_fault, Fault::label_missing) << label;
    Machine before;
    before.start(before.source.add(PageBuilder().end()));
    EXPECT_FALSE(before.interpreter.jump_to_label(label)) << label << " at the head";
  }
}

TEST(Interpreter, ANumberThatNoLabelCanHaveIsOutOfRange) {
  for (const double label : {-1.0, 4294967296.0, 1e300, kNull}) {
    Machine machine;
    machine.run(PageBuilder().load(1, label).add({.op = Op::jump_to_label, .b = 1}).end());
    EXPECT_EQ(machine.host.last_fault, Fault::label_range) << text(label);
  }
}

// Pages, switches, notes, the end

TEST(Interpreter, PagesFollowEachOther) {
  Machine machine;
  std::vector<PageBuilder> pages;
  pages.push_back(PageBuilder().block(0).next_page());
  pages.push_back(PageBuilder().next_page());
  pages.push_back(PageBuilder().block(1).end());
  machine.start(machine.source.add(std::move(pages)));
  EXPECT_EQ(machine.interpreter.run(kPlenty), Stop::over);
  EXPECT_EQ(machine.host.events, (Events{"block 0", "block 1", "end"}));
  EXPECT_EQ(machine.interpreter.running(), (Address{2, 1}));
}

TEST(Interpreter, ALoopMaySpanPages) {
  Machine machine;
  std::vector<PageBuilder> pages(2);
  Region region{.slot = 0, .state = Region::State::closed, .head = 1, .end = {1, 1}};
  pages[0].region(region).load(1, 0);
  pages[0].with_constant(Op::add_constant, 1, 1, 1).load(2, 4).three(Op::less_equal, 3, 1, 2);
  pages[0].add({Op::branch, 1, 3, 0, 6}).add({.op = Op::leave_region, .n = 0});
  pages[0].add({.op = Op::enter_region, .n = 0}).next_page();
  pages[1].block(1).add({.op = Op::repeat_region, .a = 0}).block(2).end();
  machine.start(machine.source.add(std::move(pages)));
  machine.interpreter.run(kPlenty);
  EXPECT_EQ(machine.host.events,
            (Events{"block 1", "block 1", "block 1", "block 1", "block 2", "end"}));
}

TEST(Interpreter, ASwitchThatIsOnSkips) {
  for (const bool on : {false, true}) {
    Machine machine;
    machine.interpreter.set_switches(on ? 1U << 3 : ~(1U << 3));
    machine.run(PageBuilder().add({Op::skip_when_on, 3, 0, 0, 2}).block(0).end());
    EXPECT_EQ(machine.host.events.size(), on ? 1U : 2U);
  }
}

TEST(Interpreter, TheNewestNoteIsRemembered) {
  Machine machine;
  EXPECT_EQ(machine.interpreter.note(), 0U);
  machine.run(PageBuilder().add({.op = Op::note, .n = 10}).add({.op = Op::note, .n = 20}).end());
  EXPECT_EQ(machine.interpreter.note(), 20U);
}

TEST(Interpreter, TheHostMayGoOnElsewhereAtTheEndOfTheCode) {
  Machine machine;
  int ends = 0;
  machine.host.on_end = [&] {
    if (++ends == 3) return Verdict::stop;
    machine.interpreter.restart();
    return Verdict::transferred;
  };
  EXPECT_EQ(machine.run(PageBuilder().block(0).end()), Stop::over);
  EXPECT_EQ(machine.host.events.size(), 6U);
}

// Budget and pauses

TEST(Interpreter, AnEndlessJumpStopsAtTheBudgetWhereItStands) {
  Machine machine;
  EXPECT_EQ(machine.run(PageBuilder().load(1, 1).load(2, 2).jump(2).end(), 100), Stop::budget);
  EXPECT_EQ(machine.interpreter.run(100), Stop::budget);
  EXPECT_EQ(machine.interpreter.place().line, 3U) << "the line of the endless jump";
}

// A program of everything that can be interrupted: blocks, jumps, a loop over pages, a call.
struct Everything {
  Machine machine;
  Everything() {
    std::vector<PageBuilder> pages(2);
    Region region{.slot = 0, .state = Region::State::closed, .head = 1, .end = {1, 2}};
    pages[0].region(region).load(1, 0);
    pages[0].with_constant(Op::add_constant, 1, 1, 1).load(2, 5).three(Op::less_equal, 3, 1, 2);
    pages[0].add({Op::branch, 1, 3, 0, 6}).add({.op = Op::leave_region, .n = 0});
    pages[0].add({.op = Op::enter_region, .n = 0}).block(1).jump(10).block(99).block(2).next_page();
    pages[1].to_label(7).block(98).add({.op = Op::repeat_region, .a = 0}).block(3).end();
    const CodeId code = machine.source.add(std::move(pages));
    machine.source.label(code, 7, {1, 2});
    const CodeId callee =
        machine.source.add(PageBuilder().load(4, 1).block(10).jump(3).block(11).end());
    machine.host.on_block = [this, callee](std::uint32_t n) {
      if (n == 2) machine.interpreter.call(callee, Interpreter::Locals::fresh);
      if (n == 11) machine.interpreter.return_to_caller();
      return n == 2 || n == 11 ? Verdict::transferred : Verdict::go_on;
    };
    machine.start(code);
  }
};

TEST(Interpreter, AnInterruptedRunDoesTheSameAsOneInOnePiece) {
  Everything whole;
  EXPECT_EQ(whole.machine.interpreter.run(kPlenty), Stop::over);
  for (const bool tracing : {false, true}) {
    for (std::uint64_t budget = 1; budget < 40; ++budget) {
      Everything pieces;
      pieces.machine.interpreter.set_tracing(tracing);
      int runs = 0;
      while (pieces.machine.interpreter.run(budget) == Stop::budget && ++runs < 1000) {
      }
      Events events;
      for (const std::string& event : pieces.machine.host.events) {
        if (!event.starts_with("begin")) events.push_back(event);
      }
      EXPECT_EQ(events, whole.machine.host.events) << "in pieces of " << budget;
      EXPECT_EQ(pieces.machine.local(1), whole.machine.local(1));
    }
  }
}

TEST(Interpreter, ABlockThatPausesIsNotExecutedAgain) {
  Everything whole;
  whole.machine.interpreter.run(kPlenty);
  Everything paused;
  const auto go = paused.machine.host.on_block;
  paused.machine.host.on_block = [go](std::uint32_t n) {
    const Verdict verdict = go(n);
    return verdict == Verdict::go_on ? Verdict::pause : verdict;
  };
  int runs = 0;
  while (paused.machine.interpreter.run(kPlenty) == Stop::paused) ++runs;
  EXPECT_EQ(paused.machine.host.events, whole.machine.host.events);
  EXPECT_GT(runs, 10);
}

TEST(Interpreter, ABlockThatStopsEndsTheProgram) {
  Machine machine;
  machine.host.on_block = [](std::uint32_t n) { return n == 1 ? Verdict::stop : Verdict::go_on; };
  EXPECT_EQ(machine.run(PageBuilder().block(0).block(1).block(2).end()), Stop::over);
  EXPECT_EQ(machine.host.events, (Events{"block 0", "block 1"}));
}

// Tracing

TEST(Interpreter, WhileTracingEveryBlockBeginsBeforeItRuns) {
  Machine machine;
  machine.interpreter.set_tracing(true);
  machine.run(PageBuilder().block(0).load(1, 2).block(1).end());
  EXPECT_EQ(machine.host.events,
            (Events{"begin 1", "block 0", "begin 2", "begin 3", "block 1", "begin 4", "end"}));
}

TEST(Interpreter, ABlockThatIsJumpedToAgainBeginsAgain) {
  Machine machine;
  machine.interpreter.set_tracing(true);
  machine.run(PageBuilder().jump(0).end(), 3);
  EXPECT_EQ(machine.host.events, (Events{"begin 1", "begin 1", "begin 1"}));
}

TEST(Interpreter, ABeginningThatPausesLeavesTheBlockForLaterAndIsNotRepeated) {
  Machine machine;
  machine.interpreter.set_tracing(true);
  machine.host.on_begin = [](const BlockMark&) { return Verdict::pause; };
  EXPECT_EQ(machine.run(PageBuilder().block(0).block(1).end()), Stop::paused);
  EXPECT_EQ(machine.host.events, Events{"begin 1"});
  EXPECT_EQ(machine.interpreter.place().line, 1U);
  EXPECT_EQ(machine.interpreter.run(kPlenty), Stop::paused);
  EXPECT_EQ(machine.host.events, (Events{"begin 1", "block 0", "begin 2"}));
}

TEST(Interpreter, ABeginningMayGoElsewhere) {
  Machine machine;
  machine.interpreter.set_tracing(true);
  machine.host.on_begin = [&](const BlockMark& mark) {
    if (mark.line != 1) return Verdict::go_on;
    machine.interpreter.jump({0, 2});
    return Verdict::transferred;
  };
  machine.run(PageBuilder().block(0).block(1).block(2).end());
  EXPECT_EQ(machine.host.events, (Events{"begin 1", "begin 3", "block 2", "begin 4", "end"}));
}

TEST(Interpreter, AReadThatCannotBeToldYetIsAskedOnceMore) {
  for (const bool tracing : {false, true}) {
    Machine machine;
    machine.interpreter.set_tracing(tracing);
    machine.host.variables[7] = 42;
    int asked = 0;
    machine.host.on_read = [&](double) { return ++asked < 3 ? Verdict::again : Verdict::go_on; };
    PageBuilder page;
    page.load(1, 5).add({.op = Op::read_fixed, .a = 2, .n = 7}).block(1).end();
    EXPECT_EQ(machine.run(std::move(page)), Stop::paused);
    EXPECT_EQ(machine.interpreter.run(kPlenty), Stop::paused);
    EXPECT_EQ(machine.interpreter.run(kPlenty), Stop::over);
    EXPECT_EQ(asked, 3);
    EXPECT_EQ(machine.local(2), 42);
    const auto begins =
        std::count(machine.host.events.begin(), machine.host.events.end(), "begin 2");
    EXPECT_EQ(begins, tracing ? 1 : 0);
  }
}

TEST(Interpreter, AWriteThatCannotBeDoneYetIsDoneOnceMore) {
  Machine machine;
  int asked = 0;
  machine.host.on_write = [&](double) { return ++asked < 2 ? Verdict::again : Verdict::go_on; };
  PageBuilder page;
  page.load(1, 5).add({.op = Op::write_fixed, .a = 1, .n = 7}).block(1).end();
  EXPECT_EQ(machine.run(std::move(page)), Stop::paused);
  EXPECT_EQ(machine.interpreter.run(kPlenty), Stop::over);
  EXPECT_EQ(asked, 2);
}

TEST(Interpreter, LocalsOfEveryLevelCanBeSeen) {
  Machine machine;
  PageBuilder called;
  called.load(1, 8).block(2).end();
  const CodeId other = machine.source.add(std::move(called));
  machine.host.on_block = [&](std::uint32_t block) {
    if (block == 2) return Verdict::pause;
    machine.interpreter.call(other, Interpreter::Locals::fresh);
    return Verdict::transferred;
  };
  EXPECT_EQ(machine.run(PageBuilder().load(1, 5).block(1).end()), Stop::paused);
  ASSERT_EQ(machine.interpreter.depth(), 2U);
  EXPECT_EQ(machine.interpreter.locals_of(0)[1], 5);
  EXPECT_EQ(machine.interpreter.locals_of(1)[1], 8);
}

TEST(Interpreter, ABlockThatWasHeldBackIsNotAskedForAgainWhoeverTracesMeanwhile) {
  Machine machine;
  machine.interpreter.set_tracing(true);
  bool holds = true;
  machine.host.on_begin = [&](const BlockMark& mark) {
    return mark.line == 2 && std::exchange(holds, false) ? Verdict::pause : Verdict::go_on;
  };
  EXPECT_EQ(machine.run(PageBuilder().block(1).block(2).jump(1)), Stop::paused);
  machine.interpreter.set_tracing(false);
  machine.interpreter.set_tracing(true);
  holds = true;
  EXPECT_EQ(machine.interpreter.run(kPlenty), Stop::paused);  // in the next pass
  EXPECT_EQ(std::count(machine.host.events.begin(), machine.host.events.end(), "block 2"), 1);
}

}  // namespace
}  // namespace kerf::vm::test
