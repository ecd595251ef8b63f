// Where a program goes: calls, regions, labels, pages.
#include <gtest/gtest.h>

#include <utility>

#include "lang/vm/interpreter_bench.hpp"

namespace kerf::vm::test {
namespace {

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
    EXPECT_EQ(machine.host.last_fault, Fault::label_range) << label;
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

}  // namespace
}  // namespace kerf::vm::test
