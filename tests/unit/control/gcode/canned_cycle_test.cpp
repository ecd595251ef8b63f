// Canned cycles do what a person would write by hand with G00 and G01 (docs/dialect.md §10).
#include <gtest/gtest.h>

#include "machine_run.hpp"
#include "program_text.hpp"
#include "seeded_random.hpp"

namespace kerf::test {
namespace {

constexpr int kCases = 400;
constexpr double kTolerance = 1e-9;
const std::string kHead = "O1\nG21G90G17G94S500M03\n";

/// A hole: where the tool comes from and what the cycle is told.
struct Hole {
  double initial, r, z, q, feed;
  int dwell_ms;
  bool to_initial;
};

double length(SeededRandom& random, double low, double high) {
  return thousandths(random.in(low, high));
}

Hole random_hole(SeededRandom& random) {
  Hole hole{};
  hole.z = length(random, -40, -1);
  hole.r = length(random, 1, 10);
  hole.initial = hole.r + length(random, 0, 40);
  hole.q = length(random, 0.5, 15);
  hole.feed = length(random, 50, 900);
  hole.dwell_ms = random.count(0, 2000);
  hole.to_initial = random.coin();
  return hole;
}

// What stands by hand in the place of a cycle.
class ByHand {
 public:
  explicit ByHand(const Hole& hole) : hole_(hole) {}
  ByHand& rapid(double z) { return block("G00Z" + decimal(z)); }
  ByHand& feed(double z) { return block("G01Z" + decimal(z) + "F" + decimal(hole_.feed)); }
  ByHand& dwell() {
    return hole_.dwell_ms > 0 ? block("G04P" + std::to_string(hole_.dwell_ms)) : *this;
  }
  ByHand& block(const std::string& text) {
    text_ += text + "\n";
    return *this;
  }
  /// Away from the hole: to R, or to the initial level.
  ByHand& back() { return rapid(hole_.to_initial ? hole_.initial : hole_.r); }
  [[nodiscard]] std::string text() const { return text_; }

 private:
  Hole hole_;
  std::string text_;
};

// CYC-1 to CYC-7, CYC-9, CYC-10 as docs/dialect.md lists them, from above the hole.
std::string by_hand(int code, const Hole& h) {
  ByHand hand(h);
  hand.rapid(h.r);
  const bool taps = code == 84 || code == 74;
  if (taps) hand.block("G63");  // nobody overrides a tap
  switch (code) {
    case 81: hand.feed(h.z).back(); break;
    case 82: hand.feed(h.z).dwell().back(); break;
    case 85: hand.feed(h.z).feed(h.r).back(); break;
    case 86: hand.feed(h.z).block("M05").back().block("M03"); break;
    case 89: hand.feed(h.z).dwell().feed(h.r).back(); break;
    case 84: hand.feed(h.z).dwell().block("M04").feed(h.r).dwell().block("M03").back(); break;
    case 74: hand.feed(h.z).dwell().block("M03").feed(h.r).dwell().block("M04").back(); break;
    case 83:
      for (double depth = h.r; depth > h.z;) {
        if (depth != h.r) hand.rapid(h.r).rapid(depth + 1);
        depth = std::max(h.z, thousandths(depth - h.q));
        hand.feed(depth);
      }
      hand.back();
      break;
    case 73:
      for (double depth = h.r; depth > h.z;) {
        if (depth != h.r) hand.rapid(depth + 1);
        depth = std::max(h.z, thousandths(depth - h.q));
        hand.feed(depth);
      }
      hand.back();
      break;
    default: ADD_FAILURE() << "no cycle G" << code;
  }
  if (taps) hand.block("G64");
  return hand.text();
}

std::string cycle_words(int code, const Hole& h, bool incremental) {
  std::string text = (h.to_initial ? "G98G" : "G99G") + std::to_string(code);
  text += "R" + decimal(incremental ? h.r - h.initial : h.r);
  text += "Z" + decimal(incremental ? h.z - h.r : h.z);
  if (code == 83 || code == 73) text += "Q" + decimal(h.q);
  if (code == 82 || code == 84 || code == 74 || code == 89)
    text += "P" + std::to_string(h.dwell_ms);
  return text + "F" + decimal(h.feed);
}

void expect_twins(const std::string& cycle, const std::string& hand) {
  const RunResult one = run_program(kHead + cycle + "M30\n");
  const RunResult other = run_program(kHead + hand + "M30\n");
  ASSERT_EQ(one.alarm, "") << cycle;
  ASSERT_EQ(other.alarm, "") << hand;
  ASSERT_EQ(difference(one.motions, other.motions, kTolerance), "") << "cycle:\n"
                                                                    << cycle << "by hand:\n"
                                                                    << hand;
}

class Cycle : public testing::TestWithParam<int> {};

TEST_P(Cycle, MovesAsWrittenByHand) {
  SeededRandom random(kSeed + static_cast<unsigned>(GetParam()));
  for (int i = 0; i < kCases; ++i) {
    const Hole hole = random_hole(random);
    const double x = length(random, -100, 100);
    const double y = length(random, -100, 100);
    const std::string start = "G00Z" + decimal(hole.initial) + "\n";
    const bool incremental = random.coin();
    const std::string place = incremental ? "G91" + xy(x, y) : xy(x, y);
    expect_twins(start + place + cycle_words(GetParam(), hole, incremental) + "\nG80G90\n",
                 start + "G00" + xy(x, y) + "\n" + by_hand(GetParam(), hole));
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(G, Cycle, testing::Values(73, 74, 81, 82, 83, 84, 85, 86, 89),
                         [](const auto& code) { return std::to_string(code.param); });

TEST(CannedCycle, HolesOfOneCycleAreHolesOneByOne) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const Hole hole = random_hole(random);
    const std::string start = "G00Z" + decimal(hole.initial) + "\n";
    std::string cycle = start;
    std::string hand = start;
    const int holes = random.count(2, 6);
    for (int k = 0; k < holes; ++k) {
      const std::string place = xy(length(random, -100, 100), length(random, -100, 100));
      cycle += place + (k == 0 ? cycle_words(81, hole, false) : "") + "\n";
      hand += "G00" + place + "\n" + by_hand(81, hole);
    }
    expect_twins(cycle + "G80\n", hand);
    if (HasFatalFailure()) return;
  }
}

TEST(CannedCycle, RepeatsOfAnIncrementAreARowOfHoles) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const Hole hole = random_hole(random);
    const double dx = length(random, -20, 20);
    const double dy = length(random, -20, 20);
    const int holes = random.count(1, 9);
    const std::string start = "G00Z" + decimal(hole.initial) + "\n";
    std::string hand = start;
    for (int k = 1; k <= holes; ++k) hand += "G00" + xy(k * dx, k * dy) + "\n" + by_hand(81, hole);
    for (const std::string count : {"K", "L"}) {
      expect_twins(start + "G91" + xy(dx, dy) + cycle_words(81, hole, true) + count +
                       std::to_string(holes) + "\nG80G90\n",
                   hand);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(CannedCycle, DrillsAlongTheNormalOfItsPlane) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const Hole hole = random_hole(random);
    const auto turned = [](std::string text, char from, char to) {
      for (char& c : text) c = c == from ? to : c == to ? from : c;
      return text;
    };
    const std::string start = "G00Z" + decimal(hole.initial) + "\n";
    const std::string cycle = start + xy(10, 20) + cycle_words(83, hole, false) + "\nG80\n";
    const std::string hand = start + "G00" + xy(10, 20) + "\n" + by_hand(83, hole);
    expect_twins("G19" + turned(cycle, 'X', 'Z'), turned(hand, 'X', 'Z'));
    expect_twins("G18" + turned(cycle, 'Y', 'Z'), turned(hand, 'Y', 'Z'));
    if (HasFatalFailure()) return;
  }
}

TEST(CannedCycle, PeckingAsDeepAsTheHoleIsDrillingInOneGo) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    Hole hole = random_hole(random);
    hole.q = hole.r - hole.z + length(random, 0, 5);
    const std::string start = "G00Z" + decimal(hole.initial) + "\nX5.";
    for (const int code : {73, 83}) {
      expect_twins(start + cycle_words(code, hole, false) + "\nG80\n",
                   start + cycle_words(81, hole, false) + "\nG80\n");
      if (HasFatalFailure()) return;
    }
  }
}

}  // namespace
}  // namespace kerf::test
