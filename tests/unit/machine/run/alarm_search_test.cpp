// A run that goes on behind its alarms, for a check or a preview.
#include "machine/run/alarm_search.hpp"

#include <gtest/gtest.h>

#include "machine/definition/machine_definition.hpp"
#include "machine/run/batch_run.hpp"

namespace kerf::test {
namespace {

using machine::AlarmSearch;
using machine::BatchRun;
using Status = machine::RunStatus;

class Search : public ::testing::Test {
 protected:
  BatchRun& run(const std::string& program, const std::string& machine = "mill3",
                const std::string& dialect = "") {
    const machine::MachineDefinition definition = *machine::find_machine(machine);
    machine_.emplace(definition, control::Memory(definition.parameters.n_offsets),
                     machine::Machine::Settings{.dialect = dialect});
    machine_->load(base::SourceFile::from_text("part.nc", program));
    machine_->search_alarms();
    status_ = machine_->run_to_end();
    return *machine_;
  }
  // "2:PS0007 4:PS0074"
  [[nodiscard]] std::string found() const {
    std::string text;
    for (const base::Diagnostic& each : machine_->alarm_search()->findings())
      text += (text.empty() ? "" : " ") + std::to_string(each.place.line) + ":" + each.number;
    return text;
  }
  [[nodiscard]] double at(char axis) const {
    return machine_->control().machine_position()[*machine_->definition().axes.find(axis)];
  }

  std::optional<BatchRun> machine_;
  Status status_{};
};

TEST_F(Search, GoesOnBehindEveryAlarmAndStatusIsThatOfTheFirst) {
  run("O1\nG04P1.0\nG01X10.F100\nG04P2.0\nG01X20.\nM30\n");
  EXPECT_EQ(status_, Status::alarm);
  EXPECT_EQ(machine_->alarm()->place.line, 2U);
  EXPECT_EQ(found(), "2:PS0007 4:PS0007");
  EXPECT_EQ(at('X'), 20);
}

TEST_F(Search, APlainRunStopsAtTheFirst) {
  const machine::MachineDefinition definition = *machine::find_machine("mill3");
  BatchRun machine(definition, control::Memory(definition.parameters.n_offsets));
  machine.load(base::SourceFile::from_text("part.nc", "O1\nG04P1.0\nG01X10.F100\nM30\n"));
  EXPECT_EQ(machine.run_to_end(), Status::alarm);
  EXPECT_EQ(machine.alarm_search(), nullptr);
  EXPECT_EQ(machine.statistics().motions(), 0U);
}

TEST_F(Search, WithoutAnAlarmTheRunIsAsEver) {
  run("O1\nG01X10.F100\nM30\n");
  EXPECT_EQ(status_, Status::end);
  EXPECT_FALSE(machine_->alarm_search()->any());
  EXPECT_FALSE(machine_->alarm_search()->stop());
}

TEST_F(Search, TheBlockIsLeftOutWithItsModesAndItsFeed) {
  run("O1\nG01X10.F100\nG91G03G55X50.F7.R1.\nX20.\nM30\n");
  EXPECT_EQ(found(), "3:PS0020");
  EXPECT_EQ(at('X'), 20);  // still G90
  const std::vector<std::string> modal =
      machine_->control().modal_text(machine_->control().modal());
  const auto has = [&](const char* code) {
    return std::find(modal.begin(), modal.end(), code) != modal.end();
  };
  EXPECT_TRUE(has("G01") && has("G90") && has("G54"));
  EXPECT_EQ(machine_->control().modal().feed, 100);
}

TEST_F(Search, AFailedExpressionLeavesTheWholeStatementOut) {
  run("O1\n#1=7\n#1=1/0\n#2=[#1+1/0]\nG01X#1F100\nM30\n");
  EXPECT_EQ(found(), "3:PS0112 4:PS0112");
  EXPECT_EQ(at('X'), 7);
}

TEST_F(Search, WhatDoesNotCompileIsPassed) {
  run("O1\nG01X10.F100\nG01X[1\nG01Y#\nX30.\nM30\n");
  EXPECT_EQ(machine_->alarm_search()->findings().size(), 2U);
  EXPECT_EQ(at('X'), 30);
}

TEST_F(Search, AProgramThatIsMissingIsPassed) {
  run("O1\nM98P7777\nG65P8888A1.\nG01X5.F100\nM30\n");
  EXPECT_EQ(machine_->alarm_search()->findings().size(), 2U);
  EXPECT_EQ(at('X'), 5);
}

TEST_F(Search, GoesOnInTheSubprogramAndBehindItsCall) {
  run("O1\nM98P2\nG04P2.0\nM30\nO2\nG04P1.0\nG00X3.\nM99\n");
  EXPECT_EQ(found(), "6:PS0007 3:PS0007");
  EXPECT_EQ(at('X'), 3);
}

TEST_F(Search, AMistakeOfTheFilesStructureIsOneOfThem) {
  run("O0000\nG04P1.0\nG01X10.F100\nM30\n");
  EXPECT_EQ(found(), "1:PS0074 2:PS0007");
  EXPECT_EQ(at('X'), 10);
}

TEST_F(Search, WhatTheProgramRaisesItselfEndsIt) {
  run("O1\nG04P1.0\n#3000=1(NO PART)\nG04P2.0\nM30\n");
  EXPECT_EQ(found(), "2:PS0007 3:MC3001");
}

TEST_F(Search, RunningOutEndsIt) {
  run("O1\nG04P1.0\nG01X10.F100\n");
  EXPECT_EQ(found(), "2:PS0007 3:PS5010");
}

TEST_F(Search, EachMistakeCountsOnceALineHoweverOftenItIsMet) {
  run("O1\n#1=0\nWHILE[#1LT50]DO1\n#1=#1+1\nG04P1.0\nEND1\nG04P2.0\nM30\n");
  EXPECT_EQ(found(), "5:PS0007 7:PS0007");
}

TEST_F(Search, AnEndlessLoopOfAlarmsEnds) {
  run("O1\nN1G04P1.0\nGOTO1\nM30\n");
  EXPECT_EQ(found(), "2:PS0007");
  EXPECT_TRUE(machine_->alarm_search()->is_cut_short());
}

TEST_F(Search, ALoopThatOnlyTheMistakeMakesEndlessEnds) {
  run("O1\n#1=0\nWHILE[#1LT5]DO1\n#1=#1+1/0\nG04P1.0\nEND1\nM30\n");
  EXPECT_EQ(found(), "4:PS0112 5:PS0007");
  EXPECT_TRUE(machine_->alarm_search()->is_cut_short());
  run("O1\nG04P1.0\nN1#1=1\nGOTO1\nM30\n");
  EXPECT_TRUE(machine_->alarm_search()->is_cut_short());
}

TEST_F(Search, AThousandFindingsAreEnough) {
  std::string program = "O1\n";
  for (int i = 0; i < 1500; ++i) program += "G04P1.0\n";
  run(program + "M30\n");
  EXPECT_EQ(machine_->alarm_search()->findings().size(), AlarmSearch::kMostFindings);
  EXPECT_TRUE(machine_->alarm_search()->is_cut_short());
  ASSERT_TRUE(machine_->notice());
  EXPECT_EQ(machine_->notice()->number, "BUDGET");
}

// The stop is where the axes of a plain run rest.
TEST_F(Search, TellsWhereAndWhenAControlStops) {
  const std::string program = "O1\nG01X10.F600\nG04P1.0\nG01X0.\nM30\n";
  const machine::MachineDefinition definition = *machine::find_machine("mill3");
  BatchRun plain(definition, control::Memory(definition.parameters.n_offsets));
  plain.load(base::SourceFile::from_text("part.nc", program));
  plain.run_to_end();
  run(program);
  ASSERT_TRUE(machine_->alarm_search()->stop());
  EXPECT_EQ(machine_->alarm_search()->stop()->motion, 1U);
  EXPECT_EQ(machine_->alarm_search()->stop()->time_s, plain.time_s());
  EXPECT_GT(machine_->time_s(), plain.time_s());
}

TEST_F(Search, CutterCompensationEndsWithTheBlock) {
  run("O1\nG10L12P1R2.\nG41D1G01X10.Y10.F100\nX20.\nG02X30.Y10.R1.\nX40.\nG40X50.\nM30\n");
  EXPECT_EQ(found().substr(0, 2), "5:");
  EXPECT_EQ(at('X'), 50);
  EXPECT_EQ(at('Y'), machine_->control().machine_position().values[1]);
}

TEST_F(Search, HolesOfACycleThatFailsAreLeftOut) {
  run("O1\nG81X1.Y1.Z-1.R1.F100\nX2.Q1.K-1\nX3.\nG80\nG04P1.0\nG01X9.\nM30\n");
  EXPECT_NE(found().find("6:PS0007"), std::string::npos);
  EXPECT_EQ(at('X'), 9);
}

TEST_F(Search, MovesThatTheJointsCannotFollowAreLeftOut) {
  run("O1\nG01X9000.F100\nG01X9001.\nM30\n", "arm4");
  EXPECT_EQ(machine_->alarm_search()->findings().size(), 2U);
}

TEST_F(Search, TaughtPointsGoOnUntilTheirTextEnds) {
  run("TEACH 1\nPOINT 1 2\nBAD\nPOINT P1 10 0 0 0 0\n", "laser5", "teach");
  EXPECT_EQ(status_, Status::alarm);
  EXPECT_GE(machine_->alarm_search()->findings().size(), 3U);
}

TEST_F(Search, LaserBasicGoesOnWithItsPower) {
  run("power(50)\nspeed(10)\nline(10,0)\nx=1/0\nline(20,0)\ny=2/x*(1/0)\nline(30,0)\nend\n",
      "laser3", "laser-basic");
  EXPECT_EQ(machine_->alarm_search()->findings().size(), 2U);
  EXPECT_EQ(at('X'), 30);
}

}  // namespace
}  // namespace kerf::test
