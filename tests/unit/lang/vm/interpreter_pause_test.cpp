// Programs that are interrupted and watched: budgets, pauses, tracing.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "lang/vm/interpreter_bench.hpp"

namespace kerf::vm::test {
namespace {

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
