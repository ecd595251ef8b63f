// Exercises that are judged by the part: what a program has made of the stock, and what it ran
// into.
#include <gtest/gtest.h>

#include <algorithm>

#include "training/assessment.hpp"

namespace kerf::training {
namespace {

using Finding = Criterion::Finding;
using Kind = Criterion::Kind;

Assessment judged(const Exercise& exercise, const std::string& program) {
  const auto result = assess(exercise, program);
  EXPECT_TRUE(result) << result.error().message;
  return result ? *result : Assessment{};
}

const Criterion& criterion(const Assessment& assessment, Kind kind) {
  for (const Criterion& each : assessment.criteria)
    if (each.kind == kind) return each;
  ADD_FAILURE() << "no criterion " << name_of(kind);
  return assessment.criteria.front();
}

double value(const Criterion& criterion, std::string_view name) {
  for (const auto& [key, number] : criterion.values)
    if (key == name) return number;
  ADD_FAILURE() << "no value " << name << " in: " << sentence_of(criterion);
  return 0;
}

// A slot 10 wide, 4 deep, from X10 to X30 in a block of 40 by 30 by 20, behind it a clamp that is
// 10 high. The head has four lines: the plunge is line 5.
Exercise slot() {
  Exercise e;
  e.name = "slot";
  e.machine = "mill3";
  e.file = "slot.nc";
  e.tolerance_mm = 0.05;
  e.zero_mm = {0, 0, -200};
  e.time_factor = 2;
  e.part = PartWork{.stock = "box:0,0,-20,40,30,0",
                    .fixtures = {"box:0,25,0,40,40,10"},
                    .tools =
                        "[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 10\n"
                        "flute_length = 20\nstickout = 22\n"
                        "holder = [ {height = 50, diameter = 40} ]\n",
                    .cell_mm = 0.25};
  e.solution =
      "O1\nT1 M06\nS1000 M03\nG90 G54 G00 X10. Y12. Z5.\nG01 Z-4. F300.\nX30.\nG00 Z50.\nM30\n";
  return e;
}

const std::string kHead = "O1\nT1 M06\nS1000 M03\nG90 G54 G00 X10. Y12. Z5.\n";
const std::string kFoot = "G00 Z50.\nM30\n";

TEST(AssessPart, TheSolutionIsWorthAHundred) {
  const Assessment got = judged(slot(), slot().solution);
  for (const Criterion& each : got.criteria) EXPECT_TRUE(each.met()) << sentence_of(each);
  EXPECT_EQ(got.score(), 100);
}

TEST(AssessPart, OtherWaysToTheSamePartAreAsGood) {
  Exercise exercise = slot();
  exercise.time_factor = 4;
  const std::string levels = "G00 X30. Y12. Z5.\nG01 Z-2. F300.\nX10.\nZ-4.\nX30.\nX20.\n";
  const std::string head = "O1\nT1 M06\nS1000 M03\nG90 G54\n";
  EXPECT_EQ(judged(exercise, head + levels + kFoot).score(), 100);
}

TEST(AssessPart, WithinTheToleranceTheDepthIsRight) {
  EXPECT_EQ(judged(slot(), kHead + "G01 Z-4.04 F300.\nX30.\n" + kFoot).score(), 100);
  EXPECT_LT(judged(slot(), kHead + "G01 Z-4.06 F300.\nX30.\n" + kFoot).score(), 100);
}

TEST(AssessPart, ASlotThatIsTooShallowIsToldWithItsPlaceAndByHowMuch) {
  const Assessment got = judged(slot(), kHead + "G01 Z-3.5 F300.\nX30.\n" + kFoot);
  const Criterion& work = criterion(got, Kind::all);
  EXPECT_EQ(work.finding, Finding::excess);
  EXPECT_NEAR(value(work, "max_mm"), 0.5, 0.001);
  // 20 mm of a slot 10 wide and its two halves of a circle, half a millimetre high.
  const double area = 20 * 10 + 3.14159 * 25;
  EXPECT_NEAR(value(work, "mm3"), area * 0.5, area * 0.02);
  EXPECT_NEAR(work.quality, 1 - 0.5 / 4, 0.01);
  EXPECT_NEAR(value(work, "y"), 12, 5.2);
  EXPECT_NE(sentence_of(work).find(" mm³ too much are left, 0.5 mm at X"), std::string::npos)
      << sentence_of(work);
  EXPECT_TRUE(criterion(got, Kind::only).met());
  EXPECT_TRUE(criterion(got, Kind::checks).met());
}

TEST(AssessPart, ASlotThatIsTooDeepIsToldWithTheLineThatCutIt) {
  const Assessment got = judged(slot(), kHead + "G01 Z-4. F300.\nX20.\nX30. Z-5.\n" + kFoot);
  const Criterion& only = criterion(got, Kind::only);
  EXPECT_EQ(only.finding, Finding::gouge);
  EXPECT_EQ(only.line, 7U);
  EXPECT_EQ(only.file, "slot.nc");
  EXPECT_NEAR(value(only, "max_mm"), 1, 0.01);
  EXPECT_NEAR(value(only, "z"), -5, 0.05);
  EXPECT_NE(sentence_of(only).find("are cut away, 1 mm deep at X"), std::string::npos)
      << sentence_of(only);
  EXPECT_TRUE(criterion(got, Kind::all).met());
}

TEST(AssessPart, ASlotInTheWrongPlaceIsMissingAndWrong) {
  const std::string beside = "O1\nT1 M06\nS1000 M03\nG90 G54 G00 X10. Y14. Z5.\n";
  const Assessment got = judged(slot(), beside + "G01 Z-4. F300.\nX30.\n" + kFoot);
  EXPECT_EQ(criterion(got, Kind::all).finding, Finding::excess);
  EXPECT_EQ(criterion(got, Kind::only).finding, Finding::gouge);
}

TEST(AssessPart, ACrashFailsThoughThePartIsRight) {
  const Assessment got = judged(slot(), kHead + "G01 Z-4. F300.\nX30.\nG00 Z5.\nY35.\n" + kFoot);
  EXPECT_TRUE(criterion(got, Kind::all).met());
  const Criterion& checks = criterion(got, Kind::checks);
  EXPECT_EQ(checks.finding, Finding::found_more);  // out of the clamp it goes through it again
  EXPECT_EQ(checks.code, "FIXTURE_COLLISION");
  EXPECT_EQ(checks.line, 8U);
  EXPECT_EQ(checks.points, 0);
  EXPECT_EQ(sentence_of(checks).substr(0, 21), "FIXTURE_COLLISION at ");
  EXPECT_LE(got.score(), 80);
}

TEST(AssessPart, ARapidThroughTheStockIsFoundAndMoreAreCounted) {
  const Criterion one =
      criterion(judged(slot(), kHead + "G01 Z-4. F300.\nX29.\nG00 X30.\n" + kFoot), Kind::checks);
  EXPECT_EQ(one.finding, Finding::found);
  EXPECT_EQ(one.line, 7U);
  const Assessment got = judged(slot(), kHead + "G01 Z-4. F300.\nX30.\nG00 X35.\nY8.\n" + kFoot);
  const Criterion& checks = criterion(got, Kind::checks);
  EXPECT_EQ(checks.finding, Finding::found_more);
  EXPECT_EQ(checks.code, "RAPID_IN_STOCK");
  EXPECT_EQ(checks.line, 7U);
  EXPECT_EQ(value(checks, "more"), 1);
  EXPECT_NE(sentence_of(checks).find(", and 1 more."), std::string::npos) << sentence_of(checks);
}

TEST(AssessPart, AToolThatTheExerciseDoesNotHaveIsTold) {
  std::string program = slot().solution;
  program.replace(program.find("T1"), 2, "T4");
  const Assessment got = judged(slot(), program);
  EXPECT_EQ(criterion(got, Kind::checks).finding, Finding::no_tool);
  EXPECT_EQ(sentence_of(criterion(got, Kind::checks)), "There is no tool 4 in this exercise.");
  EXPECT_LE(got.score(), 80);
}

TEST(AssessPart, NothingIsWorthNextToNothing) {
  for (const char* program : {"", "M30\n", "O1\nG90 G54 G00 Z50.\nM30\n"}) {
    const Assessment got = judged(slot(), program);
    EXPECT_LE(got.score(), 15) << program;
    EXPECT_EQ(criterion(got, Kind::all).finding, Finding::nothing_cut) << program;
  }
}

TEST(AssessPart, AnAlarmIsToldAndWhatWasCutUntilThenCounts) {
  const Assessment got = judged(slot(), kHead + "G01 Z-4. F300.\nX20.\n#1=1/0\nX30.\n" + kFoot);
  EXPECT_EQ(criterion(got, Kind::ends).finding, Finding::alarm);
  EXPECT_EQ(criterion(got, Kind::ends).line, 7U);
  const Criterion& work = criterion(got, Kind::all);
  EXPECT_EQ(work.finding, Finding::excess);
  // Of 20 mm and the two halves of a circle ten are missing.
  const double area = 20 * 10 + 3.14159 * 25;
  EXPECT_NEAR(work.quality, (area - 10 * 10) / area, 0.02);
}

TEST(AssessPart, AProgramThatDoesNotEndSaysSo) {
  const Assessment got = judged(slot(), kHead + "G01 Z-4. F300.\nN1 X30.\nX10.\nGOTO1\nM30\n");
  EXPECT_EQ(criterion(got, Kind::ends).finding, Finding::too_long);
  EXPECT_TRUE(criterion(got, Kind::all).met());
  EXPECT_LT(got.score(), 100);
}

TEST(AssessPart, AWrongExerciseIsAFailure) {
  Exercise exercise = slot();
  exercise.part->stock = "bax:1,2";
  EXPECT_FALSE(assess(exercise, slot().solution));
  exercise = slot();
  exercise.part->tools = "[[tool]]\nnumber = 1\ntype = \"flut\"\n";
  EXPECT_FALSE(assess(exercise, slot().solution));
  exercise = slot();
  exercise.solution = kHead + "G00 Z-4.\nG01 X30. F300.\n" + kFoot;
  const auto crash = assess(exercise, slot().solution);
  ASSERT_FALSE(crash);
  EXPECT_NE(crash.error().message.find("is no solution: rapid through stock"), std::string::npos)
      << crash.error().message;
}

TEST(AssessPart, AMistakeInItsTableIsToldWithItsLine) {
  const auto parsed = [](const std::string& part, const std::string& head = "") {
    const auto made = Exercise::parse(
        head +
            "file = \"a.nc\"\nmachine = \"mill3\"\ntolerance_mm = 0.02\n"
            "time_factor = 2\n[title]\nen = \"a\"\nzh-Hant = \"a\"\n[task]\nen = \"a\"\n"
            "zh-Hant = \"a\"\n[program]\nstart = \"a\"\nsolution = \"a\"\n[part]\n" +
            part,
        "a");
    return made ? std::string{} : made.error().message;
  };
  const std::string right = "stock = \"box\"\ntools = \"a\"\ncell_mm = 0.2\n";
  EXPECT_EQ(parsed(right), "");
  EXPECT_EQ(parsed(right + "fixtures = [\"box\"]\n"), "");
  EXPECT_EQ(parsed(right + "fixtures = [1]\n"), "a.toml:18: each of part.fixtures must be a text");
  EXPECT_EQ(parsed(right + "fixtures = 1\n"), "a.toml:18: part.fixtures must be a list of texts");
  EXPECT_EQ(parsed(right + "stick = 1\n"), "a.toml:18: a part has no key stick");
  EXPECT_EQ(parsed("stock = \"box\"\ntools = \"a\"\ncell_mm = 0.01\n"),
            "a.toml:17: part.cell_mm must be a number, large enough");
  EXPECT_EQ(parsed(right, "bar_mm = 30\n"),
            "a.toml:15: what is judged by its part has no clearance_z_mm and no bar_mm");
}

}  // namespace
}  // namespace kerf::training
