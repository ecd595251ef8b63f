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
  for (const auto& each : machine::builtin_machines()) {
    EXPECT_FALSE(suits(std::string(each.name).c_str(), ProgramKind::lathe));
    EXPECT_TRUE(suits(std::string(each.name).c_str(), ProgramKind::any));
  }
}

TEST(ProgramLook, ItsUsualMachineSuits) {
  for (const auto kind : {ProgramKind::any, ProgramKind::mill, ProgramKind::laser,
                          ProgramKind::laser_basic, ProgramKind::teach})
    EXPECT_TRUE(
        machine::suits(*machine::find_machine(std::string(machine::usual_machine(kind))), kind));
  EXPECT_EQ(machine::usual_machine(ProgramKind::lathe), "");
}

}  // namespace
}  // namespace kerf::test
