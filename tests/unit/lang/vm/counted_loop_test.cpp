// Loops, calls and steps that are counted by instructions of the virtual machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "lang/vm/interpreter.hpp"
#include "lang/vm/page_builder.hpp"

namespace kerf::vm::test {
namespace {

using Stop = Interpreter::Stop;

constexpr std::uint32_t kLocals = 10;
constexpr std::uint64_t kPlenty = 1'000'000;

Interpreter::Settings settings(std::span<double> globals) {
  Interpreter::Settings settings;
  settings.locals = kLocals;
  settings.globals = globals;
  settings.most_loops = 4;
  settings.most_calls = 5;
  settings.steps = 20;
  return settings;
}

struct Machine {
  HandMadeSource source;
  RecordingHost host;
  std::vector<double> globals = std::vector<double>(5, kNull);
  Interpreter interpreter{source, host, settings(globals)};

  Stop run(PageBuilder page, std::uint64_t budget = kPlenty) {
    interpreter.start(source.add(std::move(page)));
    return interpreter.run(budget);
  }
  double local(std::size_t n) { return interpreter.locals()[n]; }
  std::size_t blocks() const {
    return static_cast<std::size_t>(
        std::count_if(host.events.begin(), host.events.end(),
                      [](const auto& e) { return e.starts_with("block"); }));
  }
};

// A loop of V[variable] whose one pass does block 1. Instructions: 0 to 2 the bounds, 3 the head,
// 4 what a loop without a pass does, 5 the block, 6 the end.
PageBuilder loop(std::uint32_t variable, double from, double to, double step) {
  PageBuilder page;
  page.load(20, from).load(21, to).load(22, step);
  page.add({.op = Op::open_loop, .a = 20, .n = variable});
  page.jump(7).block(1);
  page.add({.op = Op::repeat_loop, .n = kAnyLoop});
  return page;
}

struct Case {
  double from, to, step;
  std::size_t passes;
  double left;  // value of the variable behind the loop
};

TEST(CountedLoop, MakesThePassesOfItsBoundsAndLeavesTheValueBehindTheLast) {
  for (const std::uint32_t variable : {3U, kRegisters + 2}) {
    for (const Case& c : {Case{1, 3, 1, 3, 4}, Case{1, 1, 1, 1, 2}, Case{5, 1, 1, 0, 5},
                          Case{5, 1, -2, 3, -1}, Case{0, 1, 0.1, 11, 11 * 0.1},
                          Case{0, 1 - 1e-8, 0.1, 11, 11 * 0.1}, Case{1, 2, 100, 1, 101}}) {
      Machine machine;
      EXPECT_EQ(machine.run(loop(variable, c.from, c.to, c.step).end()), Stop::over);
      EXPECT_EQ(machine.blocks(), c.passes) << c.from << " to " << c.to << " step " << c.step;
      EXPECT_EQ(variable < kRegisters ? machine.local(variable) : machine.globals[2], c.left);
    }
  }
}

TEST(CountedLoop, GoesOnWhereItStoppedWhenTheBudgetIsSpent) {
  Machine machine;
  machine.interpreter.start(machine.source.add(loop(3, 1, 4, 1).end()));
  int runs = 0;
  while (machine.interpreter.run(1) == Stop::budget) ++runs;
  EXPECT_EQ(machine.blocks(), 4U);
  EXPECT_GE(runs, 8);
}

TEST(CountedLoop, AStepOf0IsAFault) {
  Machine machine;
  machine.run(loop(3, 1, 4, 0).end());
  EXPECT_EQ(machine.host.last_fault, Fault::zero_step);
}

TEST(CountedLoop, ACounterWithoutBoundIsAnOverflow) {
  Machine machine;
  const double most = std::numeric_limits<double>::max();
  machine.run(loop(3, most, most, most).end());
  EXPECT_EQ(machine.host.last_fault, Fault::overflow);
}

TEST(CountedLoop, OneThatIsNotOpenCannotBeRepeated) {
  for (const std::uint32_t which : {kAnyLoop, 4U}) {
    Machine machine;
    PageBuilder page = which == kAnyLoop ? PageBuilder() : loop(3, 1, 1, 1);
    page.add({.op = Op::repeat_loop, .n = which});
    machine.run(page.end());
    EXPECT_EQ(machine.host.last_fault, Fault::loop_not_open);
  }
}

TEST(CountedLoop, AsManyAsAllowedMayBeOpen) {
  for (const std::uint32_t count : {4U, 5U}) {
    Machine machine;
    PageBuilder page;
    page.load(20, 1).load(21, 9).load(22, 1);
    for (std::uint32_t i = 0; i < count; ++i)
      page.add({.op = Op::open_loop, .a = 20, .n = i}).block(0);
    machine.run(page.end());
    EXPECT_EQ(machine.host.last_fault, count == 4 ? Fault::none : Fault::loop_depth);
  }
}

TEST(CountedLoop, ThatBeginsAgainDiscardsWhatIsInsideOfIt) {
  Machine machine;
  PageBuilder page;
  page.load(20, 1).load(21, 9).load(22, 1);
  for (const std::uint32_t variable : {0U, 1U, 2U, 3U, 1U, 2U, 3U, 0U, 1U})
    page.add({.op = Op::open_loop, .a = 20, .n = variable}).block(0);
  machine.run(page.end());
  EXPECT_EQ(machine.host.last_fault, Fault::none);
}

// Calls label 7, then does block 1 and ends; `routine` stands at the label.
PageBuilder caller() {
  PageBuilder page;
  page.load(1, 5).load(2, 6).add({.op = Op::call_label, .n = 7});
  return page.block(1).end();
}

constexpr std::uint32_t kRoutine = 5;  // instruction behind caller()

Stop run_with_label(Machine& machine, PageBuilder page) {
  const CodeId code = machine.source.add(std::move(page));
  machine.source.label(code, 7, {0, kRoutine});
  machine.interpreter.start(code);
  return machine.interpreter.run(kPlenty);
}

TEST(CallLabel, ComesBackBehindTheCallWithTheRegistersOfTheCaller) {
  Machine machine;
  PageBuilder page = caller();
  page.with_constant(Op::add_constant, 1, 1, 2).add({.op = Op::leave_call});
  run_with_label(machine, std::move(page));
  EXPECT_EQ(machine.host.events, (std::vector<std::string>{"block 1", "end"}));
  EXPECT_EQ(machine.local(1), 7);
}

TEST(CallLabel, WhatWasSavedComesBackAsItWasAtFirst) {
  Machine machine;
  PageBuilder page = caller();
  page.add({.op = Op::save_variable, .n = 1}).load(1, 50).add({.op = Op::save_variable, .n = 1});
  page.add({.op = Op::save_variable, .n = kRegisters + 1}).load(2, 60);
  page.add({.op = Op::store_global, .a = 2, .n = 1}).load(1, 70).add({.op = Op::leave_call});
  machine.globals[1] = 3;
  run_with_label(machine, std::move(page));
  EXPECT_EQ(machine.local(1), 5);
  EXPECT_EQ(machine.local(2), 60);
  EXPECT_EQ(machine.globals[1], 3);
}

TEST(CallLabel, ClosesTheLoopsOfTheRoutineWhenItIsLeft) {
  Machine machine;
  PageBuilder page;
  page.load(20, 1).load(21, 100).load(22, 1).add({.op = Op::call_label, .n = 7}).jump(3);
  page.add({.op = Op::open_loop, .a = 20, .n = 0}).block(0).add({.op = Op::leave_call});
  run_with_label(machine, std::move(page));
  EXPECT_EQ(machine.host.last_fault, Fault::none) << "no loop adds up";
}

TEST(CallLabel, AsDeepAsAllowed) {
  Machine machine;
  PageBuilder page = caller();
  page.block(2).add({.op = Op::call_label, .n = 7});
  run_with_label(machine, std::move(page));
  EXPECT_EQ(machine.host.last_fault, Fault::call_depth);
  EXPECT_EQ(machine.blocks(), 5U);
}

TEST(CallLabel, ToALabelThatIsMissingIsAFault) {
  Machine machine;
  machine.run(caller());
  EXPECT_EQ(machine.host.last_fault, Fault::label_missing);
  EXPECT_EQ(machine.interpreter.depth(), 1U);
}

TEST(CallLabel, LeavingTheFirstLevelIsAFault) {
  Machine machine;
  machine.run(PageBuilder().add({.op = Op::leave_call}));
  EXPECT_EQ(machine.host.last_fault, Fault::return_without_call);
}

// 6 blocks of which the first counts them all, over and over.
PageBuilder counted() {
  PageBuilder page;
  page.add({.op = Op::count_steps, .n = 6});
  for (std::uint32_t i = 1; i < 6; ++i) page.block(i);
  return page.jump(0);
}

TEST(CountSteps, EndsAtTheStepThatIsOneTooMany) {
  Machine machine;  // 20 steps: three passes and the first two blocks of the fourth
  machine.run(counted());
  EXPECT_EQ(machine.host.last_fault, Fault::steps_spent);
  EXPECT_EQ(machine.blocks(), 3U * 5 + 1);
  EXPECT_EQ(machine.interpreter.place().line, 3U);
}

TEST(CountSteps, EndsThereAlsoWhenTheRunPausesBeforeIt) {
  Machine machine;
  machine.host.on_block = [](std::uint32_t) { return Verdict::pause; };
  machine.interpreter.start(machine.source.add(counted()));
  while (machine.interpreter.run(kPlenty) == Stop::paused) {
  }
  EXPECT_EQ(machine.host.last_fault, Fault::steps_spent);
  EXPECT_EQ(machine.blocks(), 3U * 5 + 1);
}

TEST(CountSteps, AreNewAtEachStart) {
  Machine machine;
  const CodeId code = machine.source.add(counted());
  for (int i = 0; i < 2; ++i) {
    machine.host.events.clear();
    machine.interpreter.start(code);
    machine.interpreter.run(kPlenty);
    EXPECT_EQ(machine.blocks(), 3U * 5 + 1);
  }
}

TEST(ReadIfNull, AsksTheHostForWhatIsNullOnly) {
  Machine machine;
  machine.host.variables[42] = 9;
  PageBuilder page;
  page.load(1, 5).add({.op = Op::read_if_null, .a = 1, .n = 41});
  page.add({.op = Op::read_if_null, .a = 2, .n = 42});
  machine.run(page.end());
  EXPECT_EQ(machine.host.events, (std::vector<std::string>{"read 42", "end"}));
  EXPECT_EQ(machine.local(1), 5);
  EXPECT_EQ(machine.local(2), 9);
}

}  // namespace
}  // namespace kerf::vm::test
