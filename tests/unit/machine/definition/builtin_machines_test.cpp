// The built-in machines.
#include <gtest/gtest.h>

#include <limits>

#include "machine/definition/machine_definition.hpp"

namespace kerf::machine {
namespace {

using base::AxisVector;
using base::JointPoint;
using base::TipPoint;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(BuiltinMachines, AreNamedAsTheirFilesAndCanBeMade) {
  std::string names;
  for (const BuiltinMachine& builtin : builtin_machines()) {
    const auto machine = MachineDefinition::parse(builtin.toml, std::string(builtin.name));
    ASSERT_TRUE(machine) << machine.error().message;
    EXPECT_EQ(machine->name, builtin.name);
    EXPECT_EQ(machine->make_kinematics()->size(), machine->driven.size());
    names += machine->name + " ";
  }
  EXPECT_EQ(names, "arm4 cartesian-step laser-xtz laser3 laser5 lathe2 lathe3c mill3 mill4 mill5 ");
}

TEST(BuiltinMachines, MillsAndTheEngraverHaveNoLimitOfJerkUnlessTheFileSaysSo) {
  for (const char* const name : {"mill3", "laser3"}) {
    const MachineDefinition machine = *find_machine(name);
    for (const DrivenAxis& a : machine.driven) EXPECT_EQ(a.jerk, kInfinite) << name << a.name;
  }
  EXPECT_EQ(find_machine("mill5")->joint_limits().jerk, (AxisVector{{5e4, 5e4, 5e4, 7200, 7200}}));
}

TEST(BuiltinMachines, RapidsStepNoFasterThanTheAmplifiersTake) {
  for (const BuiltinMachine& builtin : builtin_machines()) {
    const MachineDefinition machine = *find_machine(std::string(builtin.name));
    const drive::StepTiming& timing = machine.drive.timing;
    const double most_hz = 1e9 / static_cast<double>(timing.pulse_width_ns + timing.pulse_gap_ns);
    for (const DrivenAxis& a : machine.driven) {
      EXPECT_LE(a.velocity_per_min / 60 * a.steps_per_unit, most_hz) << builtin.name << a.name;
    }
  }
}

TEST(BuiltinMachines, TheArmHasTheJointsOfTheGlassEngraver) {
  const MachineDefinition arm = *find_machine("arm4");
  const auto linkage = arm.make_kinematics();
  EXPECT_EQ(linkage->joints()[0].high, 32767 * 0.005);
  EXPECT_EQ(linkage->joints()[0].low, -32767 * 0.005);
  EXPECT_EQ(1 / arm.driven[0].steps_per_unit, 0.005);
  EXPECT_NEAR(1 / arm.driven[2].steps_per_unit, 0.75, 1e-15);
  EXPECT_EQ(arm.driven[3].steps_per_unit, 100);
  // A path round the shoulder goes on beyond half a turn.
  const auto joints = linkage->inverse({{-150, -80}}, {{99, -200}}, kinematics::Branch::plus);
  ASSERT_TRUE(joints) << joints.error().message;
  EXPECT_NEAR(joints->values[1], -201.841312, 1e-6);
  const auto folded = linkage->inverse({{10, 0}}, {});
  ASSERT_FALSE(folded);
  EXPECT_EQ(code_of(folded.error().kind), base::Code::joint_limit);
}

TEST(BuiltinMachines, TheFiveAxisLaserHasTheHeadOfTheTable) {
  const MachineDefinition laser = *find_machine("laser5");
  EXPECT_EQ(laser.interpolator.period_s, 0.008);
  const auto head = laser.make_kinematics();
  const JointPoint joints = *head->inverse({{100, 50, 25, 30, 90}}, {});
  EXPECT_NEAR(joints.values[0], 175, 1e-9);
  EXPECT_NEAR(joints.values[1], -30, 1e-9);
  EXPECT_NEAR(joints.values[2], 154.903811, 1e-6);
  EXPECT_FALSE(head->inverse({{0, 0, 0, 181, 0}}, {})) << "A ends at 180";
  EXPECT_TRUE(head->inverse({{0, 0, 0, 0, 7200}}, {})) << "C does not end";
  EXPECT_TRUE(laser.drive.laser.fitted());
}

TEST(BuiltinMachines, TheLensCutterHasTheConstantsOfTheTable) {
  const MachineDefinition laser = *find_machine("laser-xtz");
  const TipPoint tip = laser.make_kinematics()->forward({{75, 20, 3}});
  EXPECT_NEAR(tip.values[0], 86.602540, 1e-6);
  EXPECT_NEAR(tip.values[1], 50, 1e-6);
  EXPECT_NEAR(tip.values[2], 8, 1e-6);
  EXPECT_EQ(laser.joint_limits().velocity, (AxisVector{{100, 90, 10}}));
}

TEST(BuiltinMachines, TheEngraverHasTheTimerOfItsBoard) {
  const LaserSettings laser = find_machine("laser3")->drive.laser;
  const auto registers = drive::pwm_registers(laser.timer, {laser.pwm_frequency_hz, 0.8});
  ASSERT_TRUE(registers);
  EXPECT_EQ(registers->tcntb, 12500);
  EXPECT_EQ(registers->tcmpb, 10000);
  EXPECT_NEAR(drive::line_energy_j_mm({2000, 0.8}, laser.max_power_w, 100), 0.48, 1e-12);
}

}  // namespace
}  // namespace kerf::machine
