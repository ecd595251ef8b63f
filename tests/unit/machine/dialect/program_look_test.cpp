// For which machine a program looks to be written.
#include "machine/dialect/program_look.hpp"

#include <gtest/gtest.h>

namespace kerf::test {
namespace {

using machine::ProgramKind;

machine::ProgramLook look(const std::string& text, const std::string& name = "part.nc") {
  return machine::look_of(*base::SourceFile::from_text(name, text));
}

TEST(ProgramLook, TurningToolsWithoutYAreALathes) {
  const auto found = look("T101\nG00 z0 x-25.5\nG97 M03 S500\nG01 f50 z-2\nM30\n");
  EXPECT_EQ(found.kind, ProgramKind::lathe);
  EXPECT_EQ(found.line, 1U);
  EXPECT_EQ(found.word, "T101");
  EXPECT_EQ(look("T01M06\n(1)\nG97 S220 M03\nG00 X205. Z10.\nG01 Z0. F0.1\nM30\n").kind,
            ProgramKind::lathe);
  EXPECT_EQ(look("T0202\nG96 S200\nG71 U2. R1.\nG71 P10 Q20 U1. W.1\nN10 X10. Z0\n").kind,
            ProgramKind::lathe);
}

TEST(ProgramLook, CodesThatNoMillHasAreALathes) {
  for (const char* const text :
       {"G50 S3000\nG00 X50.\n", "G28 U0 W0\n", "G71 U2. R0.5\nG00 X50.\n",
        "G00 X50.\nG76 P020060 Q100 R0.1\n", "G70 P10 Q20\nG00 Z1.\n", "G32 Z-20. F1.5\n",
        "G00 X50. Z2.\nG01 W-20. F0.2\n", "T13013\nG00 X50.\n"})
    EXPECT_EQ(look(text).kind, ProgramKind::lathe) << text;
}

TEST(ProgramLook, TheHeaviestSignIsTold) {
  const auto found = look("T101\nG00 X50. Z2.\nG97 S500\nG50 S3000\n");
  EXPECT_EQ(found.line, 4U);
  EXPECT_EQ(found.word, "G50 S3000");
}

TEST(ProgramLook, AHabitIsNotEnough) {
  for (const char* const text :
       {"T101\nG00 X5. Z2.\n", "G97 S500 M03\nG96 S100\nG00 X5. Z2.\n", "G98\nG01 X5. Z2. F0.5\n",
        "G90 X5. Z2. F200.\n", "G04 U1.\nG00 X5.\n", "G92 S2000\nG00 X5.\n",
        "T0101 M06\nG00 X5. Z2.\n"})
    EXPECT_NE(look(text).kind, ProgramKind::lathe) << text;
}

TEST(ProgramLook, AHabitCountsOnce) {
  EXPECT_NE(look("T101\nX1. Z2.\nT202\nX2. Z2.\nT303\nX3. Z2.\n").kind, ProgramKind::lathe);
}

TEST(ProgramLook, WhatHasAYIsNoLathes) {
  EXPECT_NE(look("G50 S3000\nT0101\nG96 S200\nG00 X50. Y1. Z2.\n").kind, ProgramKind::lathe);
  EXPECT_NE(look("G00 X1. Y2.\nG01 U3. V4. F100\n").kind, ProgramKind::lathe);
  EXPECT_EQ(look("G50 S3000\nG65 P9000 X1. Y2.\nG00 X50. Z2.\n").kind, ProgramKind::lathe);
}

TEST(ProgramLook, SignsOfAMillWeighAgainstIt) {
  EXPECT_EQ(look("T0101\nG43 H1 Z50.\nG01 X5. F0.5\n").kind, ProgramKind::mill);
  EXPECT_EQ(look("G97 S500\nT101\nG81 X1. Z-3. R1.\n").kind, ProgramKind::mill);
  EXPECT_NE(look("G21 G90 G17 G94\nG92 S3000\nG96 S200 M03\nG01 X10. F100\nG97 S800\n").kind,
            ProgramKind::lathe);
  EXPECT_NE(look("T0101\nG41 D1 X5.\nG01 X5. Z2. F0.5\n").kind, ProgramKind::lathe);
}

TEST(ProgramLook, WhatTurnsCIsALathesWithC) {
  const std::string head = "T0101\nG50 S3000\nG00 X50. Z2.\n";
  const auto polar = look(head + "G12.1\nG01 X20. C5. F100\nG13.1\n");
  EXPECT_EQ(polar.kind, ProgramKind::lathe_c);
  EXPECT_EQ(polar.line, 4U);
  EXPECT_EQ(polar.word, "G12.1");
  for (const char* const text : {"G00 C90.\n", "G28 H0\n", "G07.1 C20.\n", "G01 C30. F100\n",
                                 "G83 Z-10. C90. R-2. F100\n", "M133 S2000\n"})
    EXPECT_EQ(look(head + text).kind, ProgramKind::lathe_c) << text;
  EXPECT_EQ(look("G98\nG00 X60. C0\nG83 C30. Z-4. R-2. F100\n").kind, ProgramKind::lathe_c);
}

TEST(ProgramLook, AChamferIsNoAxis) {
  const std::string head = "T0101\nG50 S3000\nG00 X50. Z2.\n";
  EXPECT_EQ(look(head + "G01 X40. C2. F0.2\nZ-20. R3.\nX50. ,C1.\n").kind, ProgramKind::lathe);
  EXPECT_EQ(look(head + "G65 P9000 C3. H4.\n").kind, ProgramKind::lathe);
}

TEST(ProgramLook, ToolChangesLengthsAndCyclesAreAMills) {
  EXPECT_EQ(look("T1 M06\nG00 X0 Y0\nS1000 M03\nG01 Z-1. F100\n").kind, ProgramKind::mill);
  EXPECT_EQ(look("G43 H1 Z50.\nG81 X1. Y1. Z-3. R1.\n").kind, ProgramKind::mill);
  EXPECT_EQ(look("T1 M06\nG97 S800 M03\nX0 Y0\nG43 H1 Z5.\nG01 Z-1.\n").kind, ProgramKind::mill);
}

TEST(ProgramLook, PowerWordsOfMovesAreALasers) {
  const auto found = look("G21\nM4 S0\nG1 X10 S500 F1000\nG1 Y10 S300\nM5\n");
  EXPECT_EQ(found.kind, ProgramKind::laser);
  EXPECT_EQ(found.word, "M4");
  EXPECT_EQ(look("G1 X10 S500 F1000\nX20 S0\nX30 S500\n").kind, ProgramKind::laser);
}

TEST(ProgramLook, AMillsSpindleIsNoBeam) {
  EXPECT_EQ(look("S1000 M03\nG00 X0 Y0\nG01 Z-1. F100\nX10.\nM30\n").kind, ProgramKind::any);
  EXPECT_EQ(look("G01 X1. S1000 M04\nX2. S900\nZ-1.\nM30\n").kind, ProgramKind::any);
}

TEST(ProgramLook, CommentsAreNoSigns) {
  EXPECT_EQ(look("(T0101 G96 X Z)\n;T0101\nG01 X1. Z1.\n").kind, ProgramKind::any);
}

TEST(ProgramLook, OtherLanguagesShowByEndingAndByText) {
  EXPECT_EQ(look("G01 X1.\n", "a.bas").kind, ProgramKind::laser_basic);
  EXPECT_EQ(look("FOR i=1 TO 3\n", "a.txt").kind, ProgramKind::laser_basic);
  EXPECT_EQ(look("TEACH 1\n", "a.txt").kind, ProgramKind::teach);
  EXPECT_EQ(look("\x01\x02", "A.PAT").kind, ProgramKind::pattern);
}

TEST(ProgramLook, NothingAtAllIsAny) {
  EXPECT_EQ(look("").kind, ProgramKind::any);
  EXPECT_EQ(look("(").kind, ProgramKind::any);
  EXPECT_EQ(look("G").kind, ProgramKind::any);
  EXPECT_EQ(look(std::string(200'000, 'X')).kind, ProgramKind::any);
}

TEST(ProgramLook, SuitsTheMachinesOfItsKindAlone) {
  const auto suits = [](const char* name, ProgramKind kind) {
    return machine::suits(*machine::find_machine(name), kind);
  };
  EXPECT_TRUE(suits("mill3", ProgramKind::mill));
  EXPECT_TRUE(suits("mill5", ProgramKind::mill));
  EXPECT_FALSE(suits("arm4", ProgramKind::mill));
  EXPECT_FALSE(suits("laser3", ProgramKind::mill));
  EXPECT_TRUE(suits("laser3", ProgramKind::laser_basic));
  EXPECT_TRUE(suits("laser-xtz", ProgramKind::laser_basic));
  EXPECT_FALSE(suits("mill3", ProgramKind::laser_basic));
  EXPECT_TRUE(suits("laser5", ProgramKind::teach));
  EXPECT_FALSE(suits("laser3", ProgramKind::teach));
  EXPECT_TRUE(suits("lathe2", ProgramKind::lathe));
  EXPECT_FALSE(suits("lathe2", ProgramKind::lathe_c));
  EXPECT_TRUE(suits("lathe3c", ProgramKind::lathe_c));
  EXPECT_FALSE(suits("lathe3c", ProgramKind::mill));
  EXPECT_FALSE(suits("mill5", ProgramKind::lathe_c));
  for (const auto& each : machine::builtin_machines())
    EXPECT_TRUE(suits(std::string(each.name).c_str(), ProgramKind::any));
}

TEST(ProgramLook, ItsUsualMachineSuits) {
  for (const auto kind :
       {ProgramKind::any, ProgramKind::mill, ProgramKind::lathe, ProgramKind::lathe_c,
        ProgramKind::laser, ProgramKind::laser_basic, ProgramKind::teach})
    EXPECT_TRUE(
        machine::suits(*machine::find_machine(std::string(machine::usual_machine(kind))), kind));
}

}  // namespace
}  // namespace kerf::test
