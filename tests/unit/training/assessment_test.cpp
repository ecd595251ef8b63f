// The training mode: what a program of an exercise is worth, and why.
#include "training/assessment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "training/code_lines.hpp"

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

// A square of 20 mm, 1 mm deep, with a head of four lines: its first cut is in line 5.
Exercise square() {
  Exercise e;
  e.name = "square";
  e.machine = "mill3";
  e.file = "square.nc";
  e.tolerance_mm = 0.02;
  e.zero_mm = {0, 0, -100};
  e.clearance_z_mm = 1;
  e.time_factor = 1.2;
  e.solution =
      "O1\nT1 M06\nS1000 M03\nG90 G54 G00 X0. Y0. Z5.\nG01 Z-1. F600.\nX20.\nY20.\nX0.\nY0.\n"
      "G00 Z50.\nM30\n";
  return e;
}

const std::string kHead = "O1\nT1 M06\nS1000 M03\nG90 G54 G00 X0. Y0. Z5.\n";
const std::string kFoot = "G00 Z50.\nM30\n";

class EachExercise : public ::testing::TestWithParam<std::size_t> {
 protected:
  [[nodiscard]] static const ExerciseFile& file() { return exercise_files()[GetParam()]; }
};

TEST_P(EachExercise, IsReadAndItsSolutionIsWorthAHundred) {
  const auto exercise = Exercise::parse(file().toml, std::string(file().name));
  ASSERT_TRUE(exercise) << exercise.error().message;
  const Assessment assessment = judged(*exercise, exercise->solution);
  for (const Criterion& each : assessment.criteria)
    EXPECT_TRUE(each.met()) << sentence_of(each) << " line " << each.line;
  EXPECT_EQ(assessment.score(), 100);
}

TEST_P(EachExercise, BeginsWithAProgramThatIsNotEnough) {
  const auto exercise = Exercise::parse(file().toml, std::string(file().name));
  ASSERT_TRUE(exercise) << exercise.error().message;
  const Assessment assessment = judged(*exercise, exercise->start);
  EXPECT_LT(assessment.score(), 60);
  EXPECT_FALSE(criterion(assessment, Kind::all).met());
}

INSTANTIATE_TEST_SUITE_P(Training, EachExercise,
                         ::testing::Range(std::size_t{0}, exercise_files().size()));

TEST(Exercises, AreAtLeastFiveOverThreeLanguages) {
  EXPECT_GE(exercises().size(), 5U);
  EXPECT_EQ(exercises().size(), exercise_files().size());
  for (const char* ending : {".nc", ".bas", ".tch"}) {
    EXPECT_TRUE(std::any_of(exercises().begin(), exercises().end(), [&](const Exercise& e) {
      return e.file.ends_with(ending);
    })) << ending;
  }
}

TEST(Exercises, AMistakeInAFileIsToldWithItsLine) {
  const auto wrong = Exercise::parse("file = \"a.nc\"\nmachin = \"mill3\"\n", "a");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().message, "a.toml:2: an exercise has no key machin");
  const std::string right = std::string(exercise_files().front().toml);
  for (const char* line : {"most_lines = \"ten\"\n", "most_lines = 1.5\n"}) {
    const auto refused = Exercise::parse(line + right, "a");
    ASSERT_FALSE(refused) << line;
    EXPECT_EQ(refused.error().message, "a.toml:1: most_lines must be a number");
  }
}

TEST(Assess, TheSolutionIsWorthAHundred) {
  EXPECT_EQ(judged(square(), square().solution).score(), 100);
}

TEST(Assess, OrderAndDirectionOfTheCutsDoNotMatter) {
  const std::string reversed =
      "O1\nT1 M06\nS1000 M03\nG90 G54 G00 X20. Y20. Z5.\nG01 Z-1. F600.\nY0.\nX0.\nY20.\nX20.\n";
  EXPECT_EQ(judged(square(), reversed + kFoot).score(), 100);
}

TEST(Assess, CutsInSeveralDepthsAreTheSameWork) {
  Exercise exercise = square();
  exercise.time_factor = 3;
  const std::string twice =
      kHead + "G01 Z-.5 F600.\nX20.\nY20.\nX0.\nY0.\nG01 Z-1.\nX20.\nY20.\nX0.\nY0.\n" + kFoot;
  EXPECT_EQ(judged(exercise, twice).score(), 100);
}

TEST(Assess, AMissingSideCostsItsShare) {
  // 80 mm of contour and 1 mm of plunge: a side less leaves 61 of 81 mm.
  const Assessment got = judged(square(), kHead + "G01 Z-1. F600.\nX20.\nY20.\nX0.\n" + kFoot);
  const Criterion& all = criterion(got, Kind::all);
  EXPECT_EQ(all.finding, Finding::missing);
  EXPECT_NEAR(value(all, "mm"), 20, 0.1);
  EXPECT_NEAR(value(all, "x"), 0, 1e-9);
  EXPECT_NEAR(all.quality, 61.0 / 81.0, 0.005);
  EXPECT_TRUE(criterion(got, Kind::only).met());
  EXPECT_LT(got.score(), 100);
}

TEST(Assess, AnExtraCutIsFoundWithItsLine) {
  const Assessment got =
      judged(square(), kHead + "G01 Z-1. F600.\nX20.\nY20.\nX0.\nY0.\nX5. Y5.\n" + kFoot);
  EXPECT_TRUE(criterion(got, Kind::all).met());
  const Criterion& only = criterion(got, Kind::only);
  EXPECT_EQ(only.finding, Finding::wrong_cut);
  EXPECT_EQ(only.line, 10U);
  EXPECT_NEAR(value(only, "mm"), std::hypot(5.0, 5.0), 0.2);
}

TEST(Assess, AContourThatIsOffIsMissingAndWrong) {
  // All of it lies 0.1 mm too far in Y: the sides along Y are where they should be, those along X
  // and the plunge in the corner are not.
  const std::string off =
      "O1\nT1 M06\nS1000 M03\nG90 G54 G00 X0. Y.1 Z5.\nG01 Z-1. F600.\nX20.\nY20.1\nX0.\nY.1\n";
  const Assessment got = judged(square(), off + kFoot);
  const Criterion& only = criterion(got, Kind::only);
  EXPECT_EQ(only.line, 6U);
  EXPECT_NEAR(value(only, "off_mm"), 0.1, 0.001);
  EXPECT_NEAR(value(criterion(got, Kind::all), "mm"), 41, 0.3);
}

TEST(Assess, ACutThatIsTooDeepIsWrongAndOneThatIsTooShallowIsMissing) {
  const std::string sides = "X20.\nY20.\nX0.\nY0.\n";
  const Assessment deep = judged(square(), kHead + "G01 Z-1.5 F600.\n" + sides + kFoot);
  EXPECT_TRUE(criterion(deep, Kind::all).met());
  EXPECT_EQ(criterion(deep, Kind::only).finding, Finding::wrong_cut);
  const Assessment shallow = judged(square(), kHead + "G01 Z-.5 F600.\n" + sides + kFoot);
  EXPECT_EQ(criterion(shallow, Kind::all).finding, Finding::missing);
  EXPECT_TRUE(criterion(shallow, Kind::only).met());
}

TEST(Assess, TheWrongToolAndASpindleThatStandsAreTold) {
  const std::string cuts = "G01 Z-1. F600.\nX20.\nY20.\nX0.\nY0.\n" + kFoot;
  const Assessment tool =
      judged(square(), "O1\nT3 M06\nS1000 M03\nG90 G54 G00 X0. Y0. Z5.\n" + cuts);
  EXPECT_EQ(criterion(tool, Kind::all).finding, Finding::other_tool);
  EXPECT_EQ(value(criterion(tool, Kind::all), "got"), 3);
  EXPECT_EQ(value(criterion(tool, Kind::all), "wanted"), 1);
  EXPECT_EQ(criterion(tool, Kind::all).line, 5U);
  const Assessment spindle = judged(square(), "O1\nT1 M06\nG90 G54 G00 X0. Y0. Z5.\n" + cuts);
  EXPECT_EQ(criterion(spindle, Kind::all).finding, Finding::spindle_stands);
}

TEST(Assess, ARapidAcrossTheWorkIsFound) {
  const Assessment got =
      judged(square(), kHead + "G01 Z-1. F600.\nX20.\nY20.\nX0.\nY0.\nG00 X50.\nG00 Z50.\nM30\n");
  const Criterion& rapids = criterion(got, Kind::rapids);
  EXPECT_EQ(rapids.finding, Finding::low_rapid);
  EXPECT_EQ(rapids.line, 10U);
  EXPECT_EQ(value(rapids, "z"), -1);
}

TEST(Assess, ARapidIntoTheWorkIsFoundAndOneIntoAHoleIsNone) {
  const std::string sides = "X20.\nY20.\nX0.\nY0.\n";
  const Assessment plunge = judged(square(), kHead + "G00 Z-1.\nG01 F600. " + sides + kFoot);
  EXPECT_EQ(criterion(plunge, Kind::rapids).finding, Finding::plunge);
  EXPECT_EQ(criterion(plunge, Kind::rapids).line, 5U);
  const Assessment again =
      judged(square(), kHead + "G01 Z-1. F600.\n" + sides + "G00 Z5.\nZ-1.\n" + kFoot);
  EXPECT_TRUE(criterion(again, Kind::rapids).met());
}

TEST(Assess, AnAlarmIsToldWithItsLineAndWhatWasCutCounts) {
  const Assessment got = judged(square(), kHead + "G01 Z-1. F600.\nX20.\n#1=1/0\nY20.\n" + kFoot);
  const Criterion& ends = criterion(got, Kind::ends);
  EXPECT_EQ(ends.finding, Finding::alarm);
  EXPECT_EQ(ends.code, "PS0112");
  EXPECT_EQ(ends.line, 7U);
  EXPECT_EQ(ends.points, 0);
  EXPECT_EQ(criterion(got, Kind::time).finding, Finding::not_timed);
  EXPECT_GT(criterion(got, Kind::all).points, 0);
}

TEST(Assess, AProgramThatDoesNotEndSaysSo) {
  const Assessment idle = judged(square(), "O1\nN1 #1=0\nGOTO1\nM30\n");
  EXPECT_EQ(criterion(idle, Kind::ends).finding, Finding::no_end);
  const Assessment moving = judged(square(), "O1\nG90 G54\nN1 G00 X1. Z5.\nX2.\nGOTO1\nM30\n");
  EXPECT_EQ(criterion(moving, Kind::ends).finding, Finding::no_end);
  const Assessment cutting = judged(square(), kHead + "G01 Z-1. F600.\nN1 X20.\nX0.\nGOTO1\nM30\n");
  EXPECT_EQ(criterion(cutting, Kind::ends).finding, Finding::too_long);
  EXPECT_LT(cutting.score(), 50);
}

TEST(Assess, NothingIsWorthNextToNothing) {
  for (const char* program : {"", "M30\n", "O1\nG90 G54 G00 Z50.\nM30\n"}) {
    const Assessment got = judged(square(), program);
    EXPECT_LE(got.score(), 15) << program;
    EXPECT_EQ(criterion(got, Kind::all).finding, Finding::nothing_cut);
  }
}

TEST(Assess, SlowCutsCostPointsOfTime) {
  const Assessment got = judged(square(), kHead + "G01 Z-1. F100.\nX20.\nY20.\nX0.\nY0.\n" + kFoot);
  EXPECT_EQ(criterion(got, Kind::time).finding, Finding::too_slow);
  EXPECT_EQ(criterion(got, Kind::time).points, 0);
  EXPECT_EQ(got.score(), 90);
}

TEST(Assess, TooManyLinesCostPoints) {
  Exercise exercise = square();
  exercise.most_lines = 11;
  EXPECT_EQ(judged(exercise, exercise.solution).score(), 100);
  exercise.most_lines = 10;
  const Assessment got = judged(exercise, exercise.solution);
  EXPECT_EQ(value(criterion(got, Kind::lines), "got"), 11);
  EXPECT_EQ(got.score(), 90);
}

TEST(Assess, ThePowerOfABeamMustBeRight) {
  Exercise exercise = square();
  exercise.machine = "laser3";
  exercise.file = "square.bas";
  exercise.zero_mm = {};
  exercise.clearance_z_mm.reset();
  exercise.solution = "speed(50)\npower(40)\nmove(0,0)\nline(20,0)\nline(20,20)\nend\n";
  EXPECT_EQ(judged(exercise, exercise.solution).score(), 100);
  const Assessment got =
      judged(exercise, "speed(50)\npower(60)\nmove(0,0)\nline(20,0)\nline(20,20)\nend\n");
  const Criterion& all = criterion(got, Kind::all);
  EXPECT_EQ(all.finding, Finding::other_power);
  EXPECT_EQ(sentence_of(all), "The power is 60 % at X0.1 Y0 Z0; it is to be 40 %.");
}

// A pin of 20 mm diameter and 30 mm length from a bar of 30 mm, square to its shoulder.
Exercise pin() {
  Exercise e;
  e.name = "pin";
  e.machine = "lathe2";
  e.file = "pin.nc";
  e.tolerance_mm = 0.02;
  e.zero_mm = {0, 0, -300};
  e.bar_mm = 30;
  e.time_factor = 4;
  e.solution =
      "O1\nT0101\nG97 S1000 M03\nG00 X25. Z2.\nG01 Z-29.9 F0.2\nX32.\nG00 Z2.\nX20.\n"
      "G01 Z-30.\nX32.\nG00 Z5.\nM30\n";
  return e;
}

const std::string kPinHead = "O1\nT0101\nG97 S1000 M03\nG00 X32. Z2.\n";
const std::string kPinFoot = "G00 Z5.\nM30\n";

TEST(AssessTurning, TheSolutionIsWorthAHundred) {
  EXPECT_EQ(judged(pin(), pin().solution).score(), 100);
}

TEST(AssessTurning, OtherPassesAndCyclesAreTheSameWork) {
  const std::string by_g90 = kPinHead + "G90 X27. Z-29.9 F0.2\nX24.\nX21.\nX20. Z-30.\n" + kPinFoot;
  EXPECT_EQ(judged(pin(), by_g90).score(), 100);
  const std::string by_g71 = kPinHead +
                             "G71 U1.5 R0.5\nG71 P1 Q2 U0.4 W0.1 F0.2\nN1 G00 X20.\n"
                             "G01 Z-30. F0.1\nN2 X32.\nG70 P1 Q2\n" +
                             kPinFoot;
  EXPECT_EQ(judged(pin(), by_g71).score(), 100);
}

TEST(AssessTurning, ADiameterThatIsOffIsToldAsADiameter) {
  const std::string thick = kPinHead + "G00 X20.1\nG01 Z-30. F0.2\nX32.\n" + kPinFoot;
  const Criterion all = criterion(judged(pin(), thick), Kind::all);
  EXPECT_EQ(all.finding, Finding::missing);
  EXPECT_NEAR(value(all, "x"), 20, 0.001);
  EXPECT_NEAR(value(all, "z"), 0, 0.201);
  EXPECT_NE(sentence_of(all).find("first at X20 Z"), std::string::npos) << sentence_of(all);
  const std::string thin = kPinHead + "G00 X19.9\nG01 Z-30. F0.2\nX32.\n" + kPinFoot;
  EXPECT_EQ(criterion(judged(pin(), thin), Kind::only).finding, Finding::wrong_cut);
}

TEST(AssessTurning, AShoulderInTheWrongPlaceIsFound) {
  const std::string far = kPinHead + "G00 X20.\nG01 Z-30.1 F0.2\nX32.\n" + kPinFoot;
  const Assessment assessment = judged(pin(), far);
  EXPECT_TRUE(criterion(assessment, Kind::all).met());
  const Criterion& only = criterion(assessment, Kind::only);
  EXPECT_EQ(only.finding, Finding::wrong_cut);
  EXPECT_NEAR(value(only, "mm"), 5.1, 0.21);
}

TEST(AssessTurning, ARapidThroughTheBarIsFoundAndOneOverWhatIsTurnedIsNone) {
  const std::string through = kPinHead + "G00 X20. Z2.\nZ-20.\nG01 Z-30. F0.2\nX32.\n" + kPinFoot;
  const Criterion rapids = criterion(judged(pin(), through), Kind::rapids);
  EXPECT_EQ(rapids.finding, Finding::plunge);
  EXPECT_EQ(rapids.line, 6U);
  const std::string back = kPinHead + "G00 X20.\nG01 Z-30. F0.2\nX32.\nG00 Z-20.\nX25.\nZ-35.\n";
  EXPECT_EQ(criterion(judged(pin(), back + kPinFoot), Kind::rapids).finding, Finding::plunge);
  const std::string above = kPinHead + "G00 X20.\nG01 Z-30. F0.2\nX32.\nG00 Z-10.\nX22.\nZ2.\n";
  EXPECT_TRUE(criterion(judged(pin(), above + kPinFoot), Kind::rapids).met());
}

TEST(AssessTurning, ABarHasNoClearanceAndItsZeroIsOnTheAxis) {
  const auto parsed = [](const std::string& more) {
    return Exercise::parse(
        "file = \"a.nc\"\nmachine = \"lathe2\"\ntolerance_mm = 0.02\n"
        "time_factor = 2\nbar_mm = 30\n" +
            more +
            "[title]\nen = \"a\"\nzh-Hant = \"a\"\n[task]\nen = \"a\"\n"
            "zh-Hant = \"a\"\n[program]\nstart = \"a\"\nsolution = \"a\"\n",
        "a");
  };
  EXPECT_TRUE(parsed(""));
  EXPECT_EQ(parsed("clearance_z_mm = 1\n").error().message,
            "a.toml:5: what is turned from a bar has no clearance_z_mm");
  EXPECT_EQ(parsed("zero_mm = [5, 0, 0]\n").error().message,
            "a.toml:6: what is turned has its zero on the axis");
}

TEST(CodeLines, AreThoseThatDoSomething) {
  EXPECT_EQ(code_lines("%\nO1 (A)\n\n(ONLY A COMMENT)\nG0 X1.\r\nM30\n%\n", "fanuc-mill"), 3);
  EXPECT_EQ(code_lines("' no\nrem no\nremote=1\nx=1 ' yes\n\nend", "laser-basic"), 3);
  EXPECT_EQ(code_lines("; no\nTEACH 1 ; yes\n  \nEND\n", "teach"), 2);
}

}  // namespace
}  // namespace kerf::training
