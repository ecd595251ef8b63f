// Programs that say the same in two ways do the same: in inches and in millimetres, absolute and
// incremental, in one block and in two.
#include <gtest/gtest.h>

#include <numbers>

#include "geometry/arc.hpp"
#include "machine_run.hpp"
#include "program_text.hpp"
#include "seeded_random.hpp"

namespace kerf::test {
namespace {

using geometry::Vec2;

constexpr int kCases = 300;
constexpr double kTolerance = 1e-6;

void expect_same(const std::string& one, const std::string& other,
                 const std::string& machine = "mill3") {
  const RunResult a = run_program(one, {.machine = machine, .radius_of_d1 = 2.54});
  const RunResult b = run_program(other, {.machine = machine, .radius_of_d1 = 2.54});
  ASSERT_EQ(a.alarm, "") << one;
  ASSERT_EQ(b.alarm, "") << other;
  ASSERT_EQ(difference(moves_of(a), moves_of(b), kTolerance), "") << one << "\nand\n" << other;
  ASSERT_NEAR(a.cut_mm, b.cut_mm, kTolerance * 1000);
  ASSERT_NEAR(a.seconds, b.seconds, 1e-6 * a.seconds);
}

// Lengths are multiples of 0.005 inch = 0.127 mm, which both units write without rounding.
struct Length {
  int steps = 0;
  [[nodiscard]] std::string in(bool inch) const {
    char text[40];
    std::snprintf(text, sizeof text, "%.4f", inch ? steps * 0.005 : steps * 0.127);
    return text;
  }
};

// The same random program in inches and in millimetres.
struct Units {
  SeededRandom random;
  bool inch;
  Units(unsigned seed, bool unit) : random(seed), inch(unit) {}

  std::string length(int low, int high) { return Length{random.count(low, high)}.in(inch); }
  std::string feed() {
    const int inches = random.count(1, 60);
    return "F" + (inch ? std::to_string(inches) + "." : decimal(inches * 25.4));
  }

  std::string block() {
    switch (random.count(0, 9)) {
      case 0: return "G00X" + length(-800, 800) + "Y" + length(-800, 800);
      case 1: return "G01Z" + length(-200, 200) + feed();
      case 2: return "G01X" + length(-800, 800) + feed();
      case 3: {
        const std::string x = length(-800, 800);
        return "G00X" + x + "\nG02I" + length(10, 200) + feed();
      }
      case 4:
        return "G91G03X" + length(50, 90) + "Y" + length(50, 90) + "R" + length(200, 400) + feed() +
               "\nG90";
      case 5:
        return "G98G81X" + length(-800, 800) + "Z" + length(-200, -100) + "R" + length(10, 90) +
               feed() + "\nG80";
      case 6:
        return "G83Y" + length(-800, 800) + "Z" + length(-200, -100) + "R" + length(10, 90) + "Q" +
               length(20, 60) + feed() + "\nG80";
      case 7: return "G52X" + length(-100, 100) + "\nG00X" + length(-100, 100) + "\nG52X0";
      case 8: return "G92X" + length(-100, 100) + "\nG00X" + length(-100, 100) + "\nG92.1X0";
      default:
        return "G68X" + length(-100, 100) + "Y" + length(-100, 100) + "R30.\nG01X" +
               length(-300, 300) + feed() + "\nG69\nG00X0Y0";
    }
  }

  std::string program() {
    std::string text = std::string("O1\n") + (inch ? "G20" : "G21") + "G90G17G94\nG00X0Y0Z0\n";
    for (int i = random.count(3, 12); i > 0; --i) text += block() + "\n";
    text += "G41D1G01X" + length(2000, 2100) + "Y" + length(0, 100) + feed() + "\nY" +
            length(500, 900) + "\nX" + length(2500, 2900) + "\nG40Y0\n";
    return text + "M30\n";
  }
};

TEST(Twins, InInchesAndInMillimetres) {
  for (unsigned i = 0; i < kCases; ++i) {
    expect_same(Units(kSeed + i, true).program(), Units(kSeed + i, false).program());
    if (HasFatalFailure()) FAIL() << "seed " << kSeed + i;
  }
}

TEST(Twins, InInchesToTheNearestIncrementOfBothUnits) {
  constexpr double kIncrement_mm = 0.001 / 2 + 0.00254 / 2 + 1e-6;
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    std::string mm = "O1\nG21G90G17G94\n";
    std::string inch = "O1\nG20G90G17G94\n";
    for (int k = 0; k < 8; ++k) {
      const double x = random.in(-300, 300);
      const double y = random.in(-300, 300);
      char text[80];
      std::snprintf(text, sizeof text, "G01X%.4fY%.4fF%.3f\n", x / 25.4, y / 25.4, 20.0);
      inch += text;
      mm += "G01" + xy(x, y) + "F508.\n";
    }
    const RunResult a = run_program(mm + "M30\n");
    const RunResult b = run_program(inch + "M30\n");
    ASSERT_EQ(difference(moves_of(a), moves_of(b), kIncrement_mm), "") << mm << "\nand\n" << inch;
  }
}

TEST(Twins, AbsoluteAndIncremental) {
  for (unsigned i = 0; i < kCases; ++i) {
    SeededRandom random(kSeed + i);
    std::string absolute = "O1\nG21G90G17G94F500\n";
    std::string incremental = "O1\nG21G91G17G94F500\n";
    double x = 0;
    double y = 0;
    for (int k = random.count(2, 15); k > 0; --k) {
      const double dx = thousandths(random.in(-50, 50));
      const double dy = thousandths(random.in(-50, 50));
      x += dx;
      y += dy;
      const std::string code = random.coin() ? "G00" : "G01";
      const double r = std::hypot(dx, dy) / 2 + 5;
      if (random.count(0, 2) == 0) {
        absolute += "G02" + xy(x, y) + "R" + decimal(r) + "\n";
        incremental += "G02" + xy(dx, dy) + "R" + decimal(r) + "\n";
      } else {
        absolute += code + xy(x, y) + "\n";
        incremental += code + xy(dx, dy) + "\n";
      }
    }
    expect_same(absolute + "M30\n", incremental + "M30\n");
    if (HasFatalFailure()) FAIL() << "seed " << kSeed + i;
  }
}

TEST(Twins, AWorkOffsetAndTheSameAddedToEveryWord) {
  for (unsigned i = 0; i < kCases; ++i) {
    SeededRandom random(kSeed + i);
    const double ox = thousandths(random.in(-200, 200));
    const double oy = thousandths(random.in(-200, 200));
    std::string offset = "O1\nG21G90G17G94F500\nG10L2P2" + xy(ox, oy) + "\nG55\n";
    std::string added = "O1\nG21G90G17G94F500\n";
    for (int k = 0; k < 6; ++k) {
      const double x = thousandths(random.in(-50, 50));
      const double y = thousandths(random.in(-50, 50));
      const double r = 120 + thousandths(random.in(0, 50));
      const bool arc = k > 0 && random.coin();
      offset += (arc ? "G03" : "G01") + xy(x, y) + (arc ? "R" + decimal(r) : "") + "\n";
      added += (arc ? "G03" : "G01") + xy(x + ox, y + oy) + (arc ? "R" + decimal(r) : "") + "\n";
    }
    expect_same(offset + "M30\n", added + "M30\n");
    if (HasFatalFailure()) FAIL() << "seed " << kSeed + i;
  }
}

TEST(Twins, WordsInAnyOrderAndInAnyWriting) {
  expect_same("O1\nG21G90G17\nG01X10.Y20.Z-5.F100\nG02X20.I5.J0\nM30\n",
              "o1\ng21 g90 g17\nF 1 0 0 Z-5. Y20. X10. G1\n(ARC) I5. G02 (TO) X+20. J.0;\nM30\n");
  expect_same("O1\nG21G90\nG00X1.5Y-.25\nM30\n", "O1\nG21G90\n#1=1.5\nG00X#1Y-[#1/6]\nM30\n");
  expect_same("O1\nG21G90\nG00X1000Y-250\nM30\n", "O1\nG21G90\nG00X1.Y-.25\nM30\n");
}

TEST(Twins, ALoopAndTheSameBlocksWrittenOut) {
  std::string loop =
      "O1\nG21G90G17G94F500\n#1=0\nWHILE[#1LT200]DO1\nG01X[#1*.5]Y[#1*#1/100]\n"
      "#1=#1+1\nEND1\nM30\n";
  std::string straight = "O1\nG21G90G17G94F500\n";
  for (int i = 0; i < 200; ++i) straight += "G01" + xy(i * 0.5, i * i / 100.0) + "\n";
  expect_same(loop, straight + "M30\n");
  const std::string jumps =
      "O1\nG21G90G17G94F500\n#1=0\nN5G01X[#1*.5]Y[#1*#1/100]\n#1=#1+1\n"
      "IF[#1LT200]GOTO5\nM30\n";
  expect_same(loop, jumps);
  const std::string calls =
      "O1\nG21G90G17G94F500\n#1=0\nM98P2L200\nM30\nO2\n"
      "G01X[#1*.5]Y[#1*#1/100]\n#1=#1+1\nM99\n";
  expect_same(loop, calls);
}

// Length, time, extents and end of a program.
void expect_same_path(const RunResult& one, const RunResult& other, const std::string& what) {
  ASSERT_EQ(one.alarm, "") << what;
  ASSERT_EQ(other.alarm, "") << what;
  ASSERT_NEAR(one.cut_mm, other.cut_mm, 1e-6 * one.cut_mm + kTolerance) << what;
  ASSERT_NEAR(one.seconds, other.seconds, 1e-6 * one.seconds + kTolerance) << what;
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_NEAR(one.low.values[i], other.low.values[i], kTolerance) << what << ", axis " << i;
    ASSERT_NEAR(one.high.values[i], other.high.values[i], kTolerance) << what << ", axis " << i;
    ASSERT_NEAR(one.position.values[i], other.position.values[i], kTolerance) << what;
  }
}

TEST(Twins, ALineInOneBlockAndInTwo) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    // Twice a whole number of thousandths, so that the half is one as well.
    const auto random_end = [&] { return 2 * thousandths(random.in(-100, 100)); };
    const double from[] = {random_end(), random_end(), random_end()};
    const double to[] = {random_end(), random_end(), random_end()};
    const auto at = [&](double part) {
      const auto on = [&](int k) { return from[k] + part * (to[k] - from[k]); };
      return xy(on(0), on(1)) + "Z" + decimal(on(2)) + "\n";
    };
    const std::string start = "O1\nG21G90F500\nG00" + at(0) + "G01";
    expect_same_path(run_program(start + at(1) + "M30\n"),
                     run_program(start + at(0.5) + at(1) + "M30\n"), start + at(1));
    if (HasFatalFailure()) return;
  }
}

TEST(Twins, AnArcInOneBlockAndInTwo) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const double angle = random.in(0.1, 2 * std::numbers::pi - 0.1);
    const double begin = random.in(0, 2 * std::numbers::pi);
    const double r = random.in(5, 100);
    const bool clockwise = random.coin();
    const auto at = [&](double part) {
      const double a = begin + (clockwise ? -1 : 1) * part * angle;
      return Vec2{thousandths(r * std::cos(a)), thousandths(r * std::sin(a))};
    };
    const Vec2 a = at(0);
    const Vec2 m = at(0.5);
    const Vec2 b = at(1);
    const std::string code = clockwise ? "G02" : "G03";
    const auto arc = [&](Vec2 from, Vec2 to) {
      return code + xy(to.u, to.v) + "I" + decimal(-from.u) + "J" + decimal(-from.v) + "\n";
    };
    const std::string head = "O1\nG21G90G17F500\nG00" + xy(a.u, a.v) + "\n";
    const RunResult whole = run_program(head + arc(a, b) + "M30\n");
    const RunResult halves = run_program(head + arc(a, m) + arc(m, b) + "M30\n");
    ASSERT_EQ(whole.alarm, "") << head << arc(a, b);
    ASSERT_EQ(halves.alarm, "") << head << arc(a, m) << arc(m, b);
    ASSERT_NEAR(whole.cut_mm, halves.cut_mm, 5e-3) << head << arc(a, b);
    ASSERT_NEAR(whole.cut_mm, r * angle, 1e-2) << head << arc(a, b);
    for (std::size_t k = 0; k < 2; ++k) {
      ASSERT_NEAR(whole.low.values[k], halves.low.values[k], 2e-3) << head << arc(a, b);
      ASSERT_NEAR(whole.high.values[k], halves.high.values[k], 2e-3) << head << arc(a, b);
    }
  }
}

// The extents of an arc against a walk along it.
TEST(Twins, AnArcReachesAsFarAsManyShortLines) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const double from_angle = random.in(0, 2 * std::numbers::pi);
    const double angle = random.in(0.1, 2 * std::numbers::pi - 0.1);
    const double r = random.in(5, 100);
    const Vec2 from{thousandths(r * std::cos(from_angle)), thousandths(r * std::sin(from_angle))};
    const Vec2 to{thousandths(r * std::cos(from_angle + angle)),
                  thousandths(r * std::sin(from_angle + angle))};
    const std::string start = "O1\nG21G90G17F500\nG00" + xy(from.u, from.v) + "\n";
    const std::string arc =
        "G03" + xy(to.u, to.v) + "I" + decimal(-from.u) + "J" + decimal(-from.v) + "\nM30\n";
    std::string lines;
    constexpr int kLines = 500;
    for (int k = 1; k <= kLines; ++k) {
      const double a = from_angle + angle * k / kLines;
      lines += "G01" + xy(r * std::cos(a), r * std::sin(a)) + "\n";
    }
    const RunResult one = run_program(start + arc);
    const RunResult other = run_program(start + lines + "M30\n");
    ASSERT_EQ(one.alarm, "") << arc;
    const double sag = r * (1 - std::cos(angle / kLines)) + 2e-3;
    for (std::size_t k = 0; k < 2; ++k) {
      ASSERT_NEAR(one.low.values[k], other.low.values[k], sag) << start << arc;
      ASSERT_NEAR(one.high.values[k], other.high.values[k], sag) << start << arc;
    }
    ASSERT_NEAR(one.cut_mm, other.cut_mm, 0.1) << start << arc;
  }
}

}  // namespace
}  // namespace kerf::test
