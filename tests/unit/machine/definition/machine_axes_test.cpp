// The axes that programs have on a machine, and what limits them.
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "machine/definition/machine_definition.hpp"
#include "machine_files.hpp"

namespace kerf::machine {
namespace {

using base::AxisVector;
using test::axis;
using test::machine_of;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::string letters(const MachineDefinition& machine) {
  std::string text;
  for (const motion::AxisConfig& a : machine.axes.axes) {
    text += a.letter;
    if (a.rotary) text += '*';
  }
  return text;
}

TEST(MachineAxes, OfProgramsAreTheDrivenOnesOrThoseOfTheTip) {
  EXPECT_EQ(letters(machine_of("cartesian")), "XY");
  EXPECT_EQ(letters(machine_of("head-ac")), "XYZA*C*");
  EXPECT_EQ(letters(machine_of("x-theta-z")), "XYZ");
  EXPECT_EQ(letters(machine_of("arm")), "XYZC*");
}

TEST(MachineAxes, OfTheTipHaveTheRatesOfWhatMovesThem) {
  const MachineDefinition arm = machine_of("arm", "[tip]\nvelocity = 10\nacceleration = 11\n");
  EXPECT_EQ(arm.axes.axes[0].rapid_per_min, 10);
  EXPECT_EQ(arm.axes.axes[1].acceleration, 11);
  EXPECT_EQ(arm.axes.axes[2].rapid_per_min, 6000) << "the lift's";
  EXPECT_EQ(arm.axes.axes[3].rapid_per_min, 6000) << "the wheel's";
}

TEST(MachineAxes, OfTheTipRefersToWhereTheJointsDo) {
  const std::string text = "name = 'm'\nkinematics = {type = 'x-theta-z', x1 = 25, z0 = 5}\n" +
                           axis("X", false, "reference = [75, 0, 0, 0]\ntravel = [0, 9]\n") +
                           axis("C", true, "reference = [90, 180, 0, 0]\n") +
                           axis("Z", false, "reference = [3, 0, 0, 0]\n");
  const auto machine = MachineDefinition::parse(text, "m.toml");
  ASSERT_TRUE(machine) << machine.error().message;
  const auto& axes = machine->axes.axes;
  EXPECT_EQ(axes[0].reference, (std::array<double, 4>{0, -25, 25, 25}));
  EXPECT_EQ(axes[1].reference, (std::array<double, 4>{100, 0, 0, 0}));
  EXPECT_EQ(axes[2].reference, (std::array<double, 4>{8, 5, 5, 5}));
  EXPECT_FALSE(axes[0].travel_min < axes[0].travel_max) << "the tip has no travel of its own";
}

TEST(MachineAxes, TravelIsTheControlsOnCartesianMachinesAndTheJointsElsewhere) {
  const std::string travel = "travel = [-5, 7]\n";
  const auto mill = MachineDefinition::parse("name='m'\n" + axis("X", false, travel), "");
  EXPECT_EQ(mill->axes.axes[0].travel_max, 7);
  EXPECT_EQ(mill->kinematics.joints[0].high, kInfinite);
  EXPECT_TRUE(mill->make_kinematics()->inverse(base::TipPoint{100}, {}));

  const auto head = MachineDefinition::parse("name='m'\nkinematics.type='head-ac'\n" +
                                                 axis("X", false, travel) + axis("Y") + axis("Z") +
                                                 axis("A", true, travel) + axis("C", true),
                                             "");
  ASSERT_TRUE(head) << head.error().message;
  EXPECT_EQ(head->kinematics.joints[0].high, 7);
  EXPECT_EQ(head->kinematics.joints[1].low, -kInfinite);
  EXPECT_EQ(head->axes.axes[0].travel_max, 0) << "the focus is not the carriage";
  EXPECT_EQ(head->axes.axes[3].travel_max, 7) << "A is A";
}

TEST(MachineLimits, CountInSeconds) {
  const auto machine = MachineDefinition::parse(
      "name='m'\n[[axis]]\nname='X'\nvelocity=6000\nacceleration=3\njerk=4\n" + axis("Y"), "");
  const planner::AxisLimits limits = machine->joint_limits();
  EXPECT_EQ(limits.velocity, (AxisVector{{100, 100}}));
  EXPECT_EQ(limits.acceleration, (AxisVector{{3, 1000}}));
  EXPECT_EQ(limits.jerk, (AxisVector{{4, kInfinite}}));
}

TEST(MachineLimits, StepsAreThoseOfTheFile) {
  const auto machine = MachineDefinition::parse(
      "name='m'\n[[axis]]\nname='X'\nvelocity=1\nsteps_per_unit=-80\nmax_rate=9\n", "");
  const auto steps = machine->step_axes();
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_EQ(steps[0].name, "X");
  EXPECT_EQ(steps[0].steps_per_unit, -80);
  EXPECT_EQ(steps[0].most_rate_hz, 9);
}

}  // namespace
}  // namespace kerf::machine
