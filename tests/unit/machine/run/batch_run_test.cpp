// The panel of the machine: cycle start, single block, stops, block skip, reset.
#include "machine/run/batch_run.hpp"

#include <gtest/gtest.h>

#include "lang/vm/value.hpp"
#include "machine/definition/machine_definition.hpp"

namespace kerf::test {
namespace {

using machine::BatchRun;
using Status = machine::RunStatus;

class Panel : public ::testing::Test {
 protected:
  // Powers a machine on with a program in its memory.
  BatchRun& load(const std::string& program,
                 const std::vector<std::pair<std::string, std::string>>& parameters = {},
                 const std::string& name = "mill3") {
    machine::MachineDefinition definition = *machine::find_machine(name);
    for (const auto& [key, value] : parameters) {
      EXPECT_TRUE(definition.parameters.set(key, value));
    }
    machine_.emplace(definition, control::Memory(definition.parameters.n_offsets));
    machine_->load(base::SourceFile::from_text("part.nc", program));
    return *machine_;
  }
  double x() { return machine_->control().machine_position().values[0]; }
  std::uint32_t line() { return machine_->control().standing_at().line; }

  std::optional<BatchRun> machine_;
};

constexpr const char* kThreeMoves = "O1\nG91G00X1.\n#1=5\n#2=6\nX1.\nX1.\nM30\n";

TEST_F(Panel, CycleStartRunsToTheEnd) {
  BatchRun& machine = load(kThreeMoves);
  EXPECT_EQ(machine.status(), Status::idle);
  EXPECT_EQ(machine.cycle_start(), Status::end);
  EXPECT_EQ(x(), 3);
}

TEST_F(Panel, SingleBlockStopsBehindEachNcBlock) {
  BatchRun& machine = load(kThreeMoves);
  machine.control().set_single_block(true);
  EXPECT_EQ(machine.cycle_start(), Status::running);
  EXPECT_EQ(x(), 1);
  EXPECT_EQ(machine.halt(), control::Halt::single_block);
  EXPECT_EQ(machine.cycle_start(), Status::running);  // passes over the macro statements
  EXPECT_EQ(x(), 2);
  EXPECT_EQ(machine.cycle_start(), Status::running);
  EXPECT_EQ(machine.cycle_start(), Status::end);
}

TEST_F(Panel, SingleBlockStopsBehindMacroStatementsWhereAParameterSaysSo) {
  BatchRun& machine = load(kThreeMoves, {{"SBM", "1"}});
  machine.control().set_single_block(true);
  const std::vector<double> wanted = {1, 1, 1, 2, 3};
  for (const double x_wanted : wanted) {
    EXPECT_EQ(machine.cycle_start(), Status::running);
    EXPECT_EQ(x(), x_wanted);
  }
  EXPECT_EQ(machine.cycle_start(), Status::end);
}

TEST_F(Panel, SingleBlockMayBeTurnedOffInTheMiddle) {
  BatchRun& machine = load(kThreeMoves, {{"SBM", "1"}});
  machine.control().set_single_block(true);
  EXPECT_EQ(machine.cycle_start(), Status::running);
  machine.control().set_single_block(false);
  EXPECT_EQ(machine.cycle_start(), Status::end);
  EXPECT_EQ(x(), 3);
}

TEST_F(Panel, ARunToTheEndPassesOverStops) {
  BatchRun& machine = load("O1\nG91G00X1.\nM00\nX1.\n#3006=1(LOOK)\nX1.\nM30\n");
  machine.control().set_single_block(true);
  EXPECT_EQ(machine.run_to_end(), Status::end);
  EXPECT_EQ(x(), 3);
}

TEST_F(Panel, ProgramStopAndMessageWaitForCycleStart) {
  BatchRun& machine = load("O1\nG91G00X1.\nM00\nX1.\n#3006=1(LOOK)\nX1.\nM30\n");
  EXPECT_EQ(machine.cycle_start(), Status::running);
  EXPECT_EQ(machine.halt(), control::Halt::program_stop);
  EXPECT_EQ(x(), 1);
  EXPECT_EQ(machine.cycle_start(), Status::running);
  EXPECT_EQ(machine.halt(), control::Halt::message);
  EXPECT_EQ(x(), 2);
  EXPECT_EQ(machine.cycle_start(), Status::end);
}

TEST_F(Panel, OptionalStopStopsOnlyWithItsSwitch) {
  const char* const program = "O1\nG91G00X1.\nM01\nX1.\nM30\n";
  BatchRun& with = load(program);
  with.control().set_optional_stop(true);
  EXPECT_EQ(with.cycle_start(), Status::stopped);
  EXPECT_EQ(x(), 1);
  EXPECT_EQ(with.cycle_start(), Status::end);
  EXPECT_EQ(x(), 2);
  EXPECT_EQ(load(program).cycle_start(), Status::end);
}

TEST_F(Panel, BlockSkipHasASwitchForEachLevel) {
  const char* const program = "O1\nG91G00X1.\n/X10.\n/2X100.\n/3X500.\nM30\n";
  EXPECT_EQ(load(program).cycle_start(), Status::end);
  EXPECT_EQ(x(), 611);
  BatchRun& machine = load(program);
  machine.control().set_block_skip(1U << 1 | 1U << 3);
  EXPECT_EQ(machine.cycle_start(), Status::end);
  EXPECT_EQ(x(), 101);
}

TEST_F(Panel, ResetLeavesTheToolAndForgetsTheProgramState) {
  BatchRun& machine = load("O1\nG91G01F100X1.\n#1=5\n#100=6\n#500=7\nM00\nX1.\nM30\n");
  EXPECT_EQ(machine.cycle_start(), Status::running);
  machine.reset();
  EXPECT_EQ(machine.status(), Status::idle);
  EXPECT_EQ(x(), 1);
  EXPECT_TRUE(vm::is_null(machine.memory().commons[0]));
  EXPECT_EQ(machine.memory().commons[100], 7);
  EXPECT_EQ(machine.cycle_start(), Status::running);  // from the head again, G00 and G90
  EXPECT_EQ(x(), 2);
}

TEST_F(Panel, ResetSwitchesTheExactStopOnAgain) {
  BatchRun& machine = load("O1\n#500=#3004\n#3004=4\nM00\nM30\n");
  for (int run = 0; run < 2; ++run) {
    EXPECT_EQ(machine.cycle_start(), Status::running);
    EXPECT_EQ(machine.memory().commons[100], 0);
    machine.reset();
  }
}

TEST_F(Panel, AnAlarmHoldsTheMachineUntilReset) {
  BatchRun& machine = load("O1\nG91G00X1.\n#3000=1(STOP)\nM30\n");
  EXPECT_EQ(machine.cycle_start(), Status::alarm);
  EXPECT_EQ(machine.alarm()->number, "MC3001");
  EXPECT_EQ(machine.cycle_start(), Status::alarm);
  EXPECT_EQ(x(), 1);
  machine.reset();
  EXPECT_FALSE(machine.alarm());
  EXPECT_EQ(machine.cycle_start(), Status::alarm);
  EXPECT_EQ(x(), 2);
}

// Where a refused move leaves the tool, the next program begins.
TEST_F(Panel, AMoveOutOfReachHoldsTheMachineUntilReset) {
  BatchRun& machine = load("O1\nG91G01F6000.X-50.\n#500=#5021\nY200.\nX-50.\nM30\n", {}, "arm4");
  EXPECT_EQ(machine.cycle_start(), Status::alarm);  // X214 Y200
  ASSERT_TRUE(machine.alarm());
  EXPECT_EQ(machine.alarm()->number, "OUT_OF_REACH");
  EXPECT_EQ(line(), 4U);
  EXPECT_EQ(x(), 214);
  EXPECT_EQ(machine.position().values[1], 0);
  EXPECT_EQ(machine.cycle_start(), Status::alarm);
  EXPECT_EQ(x(), 214);
  machine.reset();
  EXPECT_FALSE(machine.alarm());
  EXPECT_EQ(machine.cycle_start(), Status::end);  // from X214: now it is near enough
  EXPECT_EQ(machine.memory().commons[100], 164);
  EXPECT_EQ(x(), 114);
  EXPECT_EQ(machine.position().values[1], 200);
}

// What is refused behind a move under compensation is not driven later either.
TEST_F(Panel, ResetForgetsTheMoveThatWasRefusedUnderCompensation) {
  BatchRun& machine = load(
      "O1\nG10L12P1R10.\nG01X200.Y50.F6000.\nIF[#500EQ1]GOTO9\n#500=1\nG41D1X200.Y100.\n"
      "X150.Y150.\nX250.\nX100.Y20.\nG40X100.Y50.\nN9X180.\nM30\n",
      {}, "arm4");
  EXPECT_EQ(machine.cycle_start(), Status::alarm);
  ASSERT_TRUE(machine.alarm());
  EXPECT_EQ(machine.alarm()->number, "OUT_OF_REACH");
  EXPECT_EQ(machine.alarm()->place.line, 8U);
  EXPECT_EQ(x(), 140);
  EXPECT_EQ(machine.position().values[1], 160);
  machine.reset();
  EXPECT_EQ(machine.cycle_start(), Status::end);
  EXPECT_EQ(x(), 180);
  EXPECT_EQ(machine.position().values[1], 50);
}

TEST_F(Panel, TheEndResetsModesAndVariables) {
  BatchRun& machine = load("O1\nIF[#1EQ#0]GOTO1\nG00X90.\nN1G00X10.\n#1=5\nG91\nM30\n");
  EXPECT_EQ(machine.cycle_start(), Status::end);
  EXPECT_EQ(machine.cycle_start(), Status::end);
  EXPECT_EQ(x(), 10);  // G90 again, and no X90.
}

TEST_F(Panel, LocalVariablesSurviveTheResetWhereAParameterSaysSo) {
  BatchRun& machine = load("O1\n#1=#1+1\nG00X[#1*10]\nM30\n", {{"CLV", "1"}});
  EXPECT_EQ(machine.cycle_start(), Status::end);
  EXPECT_EQ(x(), 10);
  EXPECT_EQ(machine.cycle_start(), Status::end);
  EXPECT_EQ(x(), 20);
  machine.reset();
  EXPECT_EQ(machine.cycle_start(), Status::end);
  EXPECT_EQ(x(), 30);
}

TEST_F(Panel, AnInterruptRunsItsProgramBetweenTwoBlocks) {
  BatchRun& machine =
      load("O1\n#1=5\nM96P2\nG91G00X1.\nM00\nX[#1]\nM97\nM30\nO2\n#1=99\nX100.\nM99\n");
  EXPECT_EQ(machine.cycle_start(), Status::running);
  machine.control().interrupt();
  EXPECT_EQ(machine.cycle_start(), Status::end);
  EXPECT_EQ(x(), 106);  // its local variables are its own
}

TEST_F(Panel, AnInterruptCountsForNothingWithoutM96) {
  BatchRun& machine = load("O1\nG91G00X1.\nM00\nX1.\nM30\nO2\nX100.\nM99\n");
  EXPECT_EQ(machine.cycle_start(), Status::running);
  machine.control().interrupt();
  EXPECT_EQ(machine.cycle_start(), Status::end);
  EXPECT_EQ(x(), 2);
}

}  // namespace
}  // namespace kerf::test
