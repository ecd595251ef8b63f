// The END of each DO against the rule written out: from each DO forward to the END that decides.
#include "lang/gcode/loops.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <string>

#include "seeded_random.hpp"

namespace kerf::gcode {
namespace {

using State = vm::Region::State;
using From = LoopMatcher::From;

struct Mark {
  std::uint8_t slot = 0;
  bool is_end = false;
};
using Marks = std::vector<Mark>;

// Which END, or why there is none: nothing where the answer lies outside of the marks.
struct Answer {
  State state = State::unresolved;
  std::uint32_t end = 0;
  friend bool operator==(const Answer&, const Answer&) = default;
};

Answer by_the_rule(const Marks& marks, std::uint32_t index, From from, State at_end) {
  std::array<bool, vm::kRegionSlots> before{}, inside{};
  for (std::uint32_t i = 0; i < index; ++i) before[marks[i].slot] = !marks[i].is_end;
  for (std::uint32_t i = index + 1; i < marks.size(); ++i) {
    const std::uint8_t slot = marks[i].slot;
    if (!marks[i].is_end) {
      inside[slot] = true;
    } else if (slot == marks[index].slot) {
      return {State::closed, i};
    } else if (inside[slot]) {
      inside[slot] = false;
    } else if (before[slot]) {
      return {State::crossing, 0};
    } else if (from == From::middle) {
      return {State::unresolved, 0};
    }
  }
  return {at_end, 0};
}

using Answers = std::vector<std::optional<Answer>>;

Answers in_one_pass(const Marks& marks, From from, State at_end) {
  Answers answers(marks.size());
  LoopMatcher matcher(from, [&](vm::Address head, const LoopEnding& ending) {
    EXPECT_FALSE(answers[head.instruction]) << "a DO is settled once";
    answers[head.instruction] = Answer{ending.state, ending.end.instruction};
  });
  for (std::uint32_t i = 0; i < marks.size(); ++i) {
    if (marks[i].is_end) {
      matcher.take_end(marks[i].slot, {0, i});
    } else {
      matcher.take_do(marks[i].slot, {0, i});
    }
  }
  matcher.finish(at_end);
  return answers;
}

std::string text_of(const Marks& marks) {
  std::string text;
  for (const Mark& mark : marks) text += (mark.is_end ? " END" : " DO") + std::to_string(mark.slot);
  return text;
}

TEST(Loops, EachDoHasTheEndThatTheRuleGivesIt) {
  test::SeededRandom random(test::kSeed);
  for (int round = 0; round < 20'000; ++round) {
    Marks marks(static_cast<std::size_t>(random.count(1, 14)));
    for (Mark& mark : marks) mark = {static_cast<std::uint8_t>(random.count(1, 3)), random.coin()};
    const From from = random.coin() ? From::head : From::middle;
    const State at_end = random.coin() ? State::open : State::unresolved;
    const Answers answers = in_one_pass(marks, from, at_end);
    for (std::uint32_t i = 0; i < marks.size(); ++i) {
      if (marks[i].is_end) continue;
      ASSERT_TRUE(answers[i]) << text_of(marks) << ", mark " << i;
      ASSERT_EQ(*answers[i], by_the_rule(marks, i, from, at_end))
          << text_of(marks) << ", mark " << i;
    }
  }
}

double seconds_for(std::size_t marks_of_each_kind) {
  Marks marks(marks_of_each_kind, {1, false});
  marks.insert(marks.end(), marks_of_each_kind, {2, true});
  marks.insert(marks.end(), marks_of_each_kind, {1, true});
  const auto begin = std::chrono::steady_clock::now();
  const Answers answers = in_one_pass(marks, From::head, State::open);
  EXPECT_TRUE(answers[0]);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// The rule above needs hours for as many.
TEST(Loops, AMillionLoopsWithinEachOtherAreMatchedAtOnce) { EXPECT_LT(seconds_for(1'000'000), 30); }

}  // namespace
}  // namespace kerf::gcode
