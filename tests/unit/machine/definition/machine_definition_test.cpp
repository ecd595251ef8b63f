// Machine files: every key with its range and default.
#include "machine/definition/machine_definition.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "machine_files.hpp"

namespace kerf::machine {
namespace {

using kinematics::Kind;
using planner::Sampling;
using test::axis;
using test::file_of;
using test::machine_of;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::string refusal(const std::string& toml) {
  const auto machine = MachineDefinition::parse(toml, "m.toml");
  return machine ? "" : machine.error().message;
}

std::string refusal_of_set(MachineDefinition& machine, const std::string& key,
                           const std::string& value) {
  const auto set = machine.set(key, value);
  return set ? "" : set.error().message;
}

/// A key, a value other than its default, where it must arrive; what it does not take, and how that
/// is said.
struct KeyCase {
  std::string type;
  std::string key;
  std::string value;
  double wanted;
  std::function<double(const MachineDefinition&)> read;
  std::string wrong;
  std::string takes;
};

double enumerated(auto value) { return static_cast<double>(value); }

using M = const MachineDefinition&;

std::vector<KeyCase> axis_keys() {
  return {
      {"cartesian", "axis.X.velocity", "1200", 1200,
       [](M m) { return m.driven[0].velocity_per_min; }, "0", "a positive number"},
      {"cartesian", "axis.X.acceleration", "50.5", 50.5,
       [](M m) { return m.driven[0].acceleration; }, "0", "a positive number"},
      {"cartesian", "axis.X.jerk", "7e4", 7e4, [](M m) { return m.driven[0].jerk; }, "-1",
       "a number that is not negative"},
      {"cartesian", "axis.X.jerk", "0", kInfinite, [](M m) { return m.driven[0].jerk; }, "-0.1",
       "a number that is not negative"},
      {"cartesian", "axis.X.steps_per_unit", "-200", -200,
       [](M m) { return m.driven[0].steps_per_unit; }, "0", "a number other than 0"},
      {"cartesian", "axis.X.max_rate", "1e5", 1e5, [](M m) { return m.driven[0].most_rate_hz; },
       "-1", "a number that is not negative"},
      {"arm", "axis.T1.velocity", "90", 90, [](M m) { return m.driven[0].velocity_per_min; }, "-3",
       "a positive number"},
  };
}

std::vector<KeyCase> linkage_keys() {
  return {
      {"x-theta-z", "kinematics.x1", "-25", -25, [](M m) { return m.kinematics.x_theta_z.x1_mm; },
       "inf", "a number"},
      {"x-theta-z", "kinematics.theta0_deg", "10", 10,
       [](M m) { return m.kinematics.x_theta_z.theta0_deg; }, "nan", "a number"},
      {"x-theta-z", "kinematics.z0", "5", 5, [](M m) { return m.kinematics.x_theta_z.z0_mm; },
       "-inf", "a number"},
      {"head-ac", "kinematics.r_a", "-110", -110, [](M m) { return m.kinematics.head.r_a_mm; },
       "inf", "a number"},
      {"head-ac", "kinematics.r_c", "0", 0, [](M m) { return m.kinematics.head.r_c_mm; }, "nan",
       "a number"},
      {"arm", "kinematics.upper_arm", "200", 200, [](M m) { return m.kinematics.arm.upper_arm_mm; },
       "0", "a positive number"},
      {"arm", "kinematics.forearm", "90.5", 90.5, [](M m) { return m.kinematics.arm.forearm_mm; },
       "-1", "a positive number"},
      {"arm", "kinematics.forearm_absolute", "true", 1,
       [](M m) { return enumerated(m.kinematics.arm.forearm_absolute); }, "1", "true or false"},
      {"arm", "kinematics.elbow", "minus", 1,
       [](M m) { return enumerated(m.kinematics.arm.elbow_minus); }, "left", "plus or minus"},
  };
}

std::vector<KeyCase> tip_keys() {
  return {
      {"arm", "tip.velocity", "100", 100, [](M m) { return m.tip.velocity_per_min; }, "0",
       "a positive number"},
      {"x-theta-z", "tip.acceleration", "7", 7, [](M m) { return m.tip.acceleration; }, "0",
       "a positive number"},
  };
}

std::vector<KeyCase> interpolator_keys() {
  return {
      {"cartesian", "interpolator.period_ms", "8", 0.008,
       [](M m) { return m.interpolator.period_s; }, "0", "a number from 0.01 to 1000"},
      {"cartesian", "interpolator.mode", "tail", enumerated(Sampling::tail),
       [](M m) { return enumerated(m.interpolator.sampling); }, "head",
       "planned, tail, equal or literal"},
      {"cartesian", "interpolator.mode", "equal", enumerated(Sampling::equal),
       [](M m) { return enumerated(m.interpolator.sampling); }, "3",
       "planned, tail, equal or literal"},
      {"cartesian", "interpolator.step_mm", "0.25", 0.25,
       [](M m) { return m.interpolator.step_mm; }, "0", "a number from 0.0001 to 1000"},
      {"cartesian", "interpolator.tolerance", "0", 0,
       [](M m) { return m.interpolator.tolerance_mm; }, "-0.01", "a number from 0 to 1000"},
      {"cartesian", "interpolator.chord_tolerance", "0.02", 0.02,
       [](M m) { return m.interpolator.chord_tolerance_mm; }, "0", "a number from 1e-06 to 1000"},
  };
}

std::vector<KeyCase> drive_keys() {
  return {
      {"cartesian", "drive.pulse_width_ns", "4294967295", 4294967295.0,
       [](M m) { return enumerated(m.drive.timing.pulse_width_ns); }, "4294967296",
       "a whole number from 1 to 4294967295"},
      {"cartesian", "drive.pulse_gap_ns", "1", 1,
       [](M m) { return enumerated(m.drive.timing.pulse_gap_ns); }, "0",
       "a whole number from 1 to 4294967295"},
      {"cartesian", "drive.direction_setup_ns", "0", 0,
       [](M m) { return enumerated(m.drive.timing.direction_setup_ns); }, "0.5",
       "a whole number from 0 to 4294967295"},
      {"cartesian", "drive.band_steps", "0.25", 0.25, [](M m) { return m.drive.timing.band_steps; },
       "0.3", "a number from 0 to 0.25"},
      {"arm", "drive.crystal_hz", "12000000", 1e-6, [](M m) { return m.drive.arm.clock.tick_s(); },
       "600000000", "a whole number from 1 to 500000000"},
      {"arm", "drive.split", "integer", enumerated(drive::TimerSplit::integer),
       [](M m) { return enumerated(m.drive.arm.split); }, "half", "exact or integer"},
      {"arm", "drive.half_period_ticks", "16777216", 16777216,
       [](M m) { return enumerated(m.drive.arm.half_period_ticks); }, "16777217",
       "a whole number from 1 to 16777216"},
      {"arm", "drive.fast_rate", "900", 900, [](M m) { return m.drive.arm.fast.rate_hz; }, "0",
       "a positive number"},
      {"arm", "drive.fast_start", "50", 50, [](M m) { return m.drive.arm.fast.start_hz; }, "0",
       "a positive number"},
      {"arm", "drive.fast_acceleration", "10", 10,
       [](M m) { return m.drive.arm.fast.acceleration_hz_s; }, "0", "a positive number"},
  };
}

std::vector<KeyCase> laser_keys() {
  return {
      {"cartesian", "drive.max_power_w", "60", 60,
       [](M m) { return m.drive.laser.fitted() ? m.drive.laser.max_power_w : -1; }, "-1",
       "a number that is not negative"},
      {"cartesian", "drive.pwm_frequency_hz", "20000", 20000,
       [](M m) { return m.drive.laser.pwm_frequency_hz; }, "0", "a positive number"},
      {"cartesian", "drive.spot_mm", "0.05", 0.05, [](M m) { return m.drive.laser.spot_mm; }, "0",
       "a positive number"},
      {"cartesian", "drive.pclk_hz", "66.5e6", 66.5e6,
       [](M m) { return m.drive.laser.timer.clock_hz; }, "0", "a positive number"},
      {"cartesian", "drive.prescaler", "255", 255,
       [](M m) { return enumerated(m.drive.laser.timer.prescaler); }, "256",
       "a whole number from 0 to 255"},
      {"cartesian", "drive.divider", "16", 16,
       [](M m) { return enumerated(m.drive.laser.timer.divider); }, "1", "2, 4, 8 or 16"},
      {"cartesian", "drive.output", "active_before_match",
       enumerated(drive::PwmTimer::Output::active_before_match),
       [](M m) { return enumerated(m.drive.laser.timer.output); }, "inverted",
       "active_after_match or active_before_match"},
      {"cartesian", "drive.hidden_tick", "true", enumerated(drive::PwmTimer::Counting::hidden_tick),
       [](M m) { return enumerated(m.drive.laser.timer.counting); }, "yes", "true or false"},
  };
}

std::vector<KeyCase> key_cases() {
  std::vector<KeyCase> all;
  for (const auto& keys :
       {axis_keys(), linkage_keys(), tip_keys(), interpolator_keys(), drive_keys(), laser_keys()})
    all.insert(all.end(), keys.begin(), keys.end());
  return all;
}

bool is_word(const std::string& value) {
  return std::isalpha(static_cast<unsigned char>(value[0])) != 0 && value != "true" &&
         value != "false" && value != "inf" && value != "nan";
}

/// A file in which `key` has `value`, its line the 3rd; of an axis the 7th, as the axes begin
/// there.
struct Written {
  std::string toml;
  int line = 3;
};
Written written(const KeyCase& c, const std::string& value) {
  const std::string text = is_word(value) ? "\"" + value + "\"" : value;
  if (!c.key.starts_with("axis.")) return {file_of(c.type, c.key + " = " + text + "\n"), 3};
  const std::string item = c.key.substr(c.key.rfind('.') + 1);
  std::string toml = file_of(c.type, {});
  const std::size_t at = toml.find("velocity");
  const std::size_t end = toml.find('\n', at);
  if (item == "velocity") {
    toml.replace(at, end - at, item + " = " + text);
    return {toml, 6};
  }
  toml.insert(end + 1, item + " = " + text + "\n");
  return {toml, 7};
}

TEST(MachineFile, EveryKeyArrivesWhereItIsUsed) {
  for (const KeyCase& c : key_cases()) {
    const auto machine = MachineDefinition::parse(written(c, c.value).toml, "m.toml");
    ASSERT_TRUE(machine) << c.key << ": " << machine.error().message;
    EXPECT_EQ(c.read(*machine), c.wanted) << c.key;
  }
}

TEST(MachineFile, AValueOutOfRangeIsRefusedWithItsLine) {
  for (const KeyCase& c : key_cases()) {
    const Written file = written(c, c.wrong);
    EXPECT_EQ(refusal(file.toml), "m.toml:" + std::to_string(file.line) + ": " +
                                      c.key.substr(c.key.rfind('.') + 1) + " must be " + c.takes)
        << c.key;
  }
}

TEST(MachineSet, EveryKeyArrivesWhereItIsUsed) {
  for (const KeyCase& c : key_cases()) {
    MachineDefinition machine = machine_of(c.type);
    EXPECT_EQ(refusal_of_set(machine, c.key, c.value), "");
    EXPECT_EQ(c.read(machine), c.wanted) << c.key;
  }
}

TEST(MachineSet, AValueOutOfRangeIsRefusedAndChangesNothing) {
  for (const KeyCase& c : key_cases()) {
    MachineDefinition machine = machine_of(c.type);
    const double before = c.read(machine);
    for (const std::string& wrong : {c.wrong, std::string(), c.value + "x"}) {
      EXPECT_EQ(refusal_of_set(machine, c.key, wrong),
                "--machine-set " + c.key + "=" + wrong + ": " + c.takes + " is expected");
    }
    EXPECT_EQ(c.read(machine), before) << c.key;
  }
}

TEST(MachineSet, AnUnknownKeyIsRefused) {
  MachineDefinition machine = machine_of("arm");
  for (const std::string key :
       {"", "axis", "beam.speed", "kinematics", "kinematics.", "kinematics.type", "drive.colour",
        "axis.T1.", "axis.T1.colour", "axis.T1.travel", "interpolator.period", "name", ".x1"}) {
    const std::string said = refusal_of_set(machine, key, "1");
    const std::string wanted = "--machine-set " + key + "=1: ";
    EXPECT_EQ(said,
              wanted + (key == "axis" ? "the machine has no such axis" : "there is no such key"));
  }
  EXPECT_EQ(refusal_of_set(machine, "axis.X.velocity", "1"),
            "--machine-set axis.X.velocity=1: the machine has no such axis")
      << "X is an axis of the tip";
  EXPECT_EQ(refusal_of_set(machine, "spindle.speed", "1"),
            "--machine-set spindle.speed=1: the machine has no such spindle");
}

TEST(MachineSet, AKeyOfAnotherLinkageIsRefused) {
  MachineDefinition mill = machine_of("cartesian");
  EXPECT_EQ(refusal_of_set(mill, "kinematics.r_a", "100"),
            "--machine-set kinematics.r_a=100: a machine of the type cartesian has no such key");
  MachineDefinition stepped = machine_of("cartesian-step");
  EXPECT_EQ(refusal_of_set(stepped, "tip.velocity", "1"),
            "--machine-set tip.velocity=1: a machine of the type cartesian-step has no such key");
  MachineDefinition head = machine_of("head-ac");
  for (const char* const key : {"kinematics.x1", "kinematics.forearm", "tip.acceleration"}) {
    EXPECT_NE(refusal_of_set(head, key, "1"), "") << key;
  }
}

TEST(MachineSet, OfModeAndStepTheLaterCounts) {
  MachineDefinition machine = machine_of("cartesian");
  ASSERT_TRUE(machine.set("interpolator.step_mm", "2"));
  EXPECT_EQ(machine.interpolator.sampling, Sampling::equal_steps);
  ASSERT_TRUE(machine.set("interpolator.mode", "planned"));
  EXPECT_EQ(machine.interpolator.sampling, Sampling::planned);
  const MachineDefinition both =
      machine_of("cartesian", "interpolator.step_mm = 3\ninterpolator.mode = \"tail\"\n");
  EXPECT_EQ(both.interpolator.sampling, Sampling::equal_steps) << "in a file the step counts more";
}

TEST(MachineSet, AStepLeavesTheLiteralModeAsItIs) {
  const std::pair<const char*, const char*> mode{"interpolator.mode", "literal"};
  const std::pair<const char*, const char*> step{"interpolator.step_mm", "2"};
  for (const auto& keys : {std::array{mode, step}, std::array{step, mode}}) {
    MachineDefinition machine = machine_of("cartesian");
    for (const auto& [key, value] : keys) ASSERT_TRUE(machine.set(key, value));
    EXPECT_EQ(machine.interpolator.sampling, Sampling::literal);
    EXPECT_EQ(machine.interpolator.step_mm, 2);
  }
  const MachineDefinition file =
      machine_of("cartesian", "interpolator.step_mm = 3\ninterpolator.mode = \"literal\"\n");
  EXPECT_EQ(file.interpolator.sampling, Sampling::literal);
}

TEST(MachineSet, TheFastRampIsCheckedAsAWhole) {
  MachineDefinition machine = machine_of("arm");
  EXPECT_EQ(refusal_of_set(machine, "drive.fast_rate", "100"),
            "--machine-set drive.fast_rate=100: fast_start, 112.5, is above fast_rate, 100");
  EXPECT_EQ(machine.drive.arm.fast.rate_hz, 400);
  EXPECT_EQ(refusal(file_of("arm", "[drive]\nfast_start = 500\n")),
            "m.toml:3: fast_start, 500, is above fast_rate, 400");
}

TEST(MachineSet, RatesReachTheProgramsAxes) {
  MachineDefinition mill = machine_of("cartesian");
  ASSERT_TRUE(mill.set("axis.Y.velocity", "77"));
  EXPECT_EQ(mill.axes.axes[1].rapid_per_min, 77);
  MachineDefinition arm = machine_of("arm");
  ASSERT_TRUE(arm.set("tip.velocity", "88"));
  ASSERT_TRUE(arm.set("axis.Z.velocity", "99"));
  EXPECT_EQ(arm.axes.axes[0].rapid_per_min, 88);
  EXPECT_EQ(arm.axes.axes[2].rapid_per_min, 99);
}

TEST(MachineSet, LengthsReachTheLinkage) {
  MachineDefinition arm = machine_of("arm");
  ASSERT_TRUE(arm.set("kinematics.upper_arm", "200"));
  EXPECT_EQ(arm.make_kinematics()->forward({}).values[0], 332);
  EXPECT_EQ(arm.axes.axes[0].reference[0], 332) << "where the tip is with all joints at 0";
}

TEST(MachineFile, HasDefaultsForEverythingButNameAxesAndVelocities) {
  const auto machine = MachineDefinition::parse("name = 'm'\n[[axis]]\nname='X'\nvelocity=1\n", "");
  ASSERT_TRUE(machine);
  EXPECT_EQ(machine->dialect, "fanuc-mill");
  EXPECT_EQ(machine->linkage, "cartesian");
  EXPECT_EQ(machine->kinematics.kind, Kind::cartesian);
  const DrivenAxis& x = machine->driven[0];
  EXPECT_EQ(x.acceleration, 1000);
  EXPECT_EQ(x.jerk, kInfinite);
  EXPECT_EQ(x.travel_low, -kInfinite);
  EXPECT_EQ(x.travel_high, kInfinite);
  EXPECT_EQ(x.steps_per_unit, 100);
  EXPECT_EQ(x.most_rate_hz, 0);
  EXPECT_EQ(machine->interpolator.period_s, 0.001);
  EXPECT_EQ(machine->interpolator.sampling, Sampling::planned);
  EXPECT_EQ(machine->interpolator.tolerance_mm, 0.01);
  EXPECT_EQ(machine->interpolator.chord_tolerance_mm, 0.001);
  EXPECT_EQ(machine->drive.arm.split, drive::TimerSplit::exact);
  EXPECT_FALSE(machine->drive.laser.fitted());
  const MachineDefinition head = machine_of("head-ac");
  EXPECT_EQ(head.kinematics.head.r_a_mm, 150);
  EXPECT_EQ(head.kinematics.head.r_c_mm, 80);
  const MachineDefinition arm = machine_of("arm");
  EXPECT_EQ(arm.kinematics.arm.upper_arm_mm, 132);
  EXPECT_EQ(arm.kinematics.arm.forearm_mm, 132);
  EXPECT_EQ(arm.tip.velocity_per_min, 6000);
}

TEST(MachineFile, WhatIsWrongIsSaidWithItsLine) {
  struct Row {
    std::string toml;
    std::string said;
  };
  const std::string head = "name = 'm'\n";
  const std::string x = "[[axis]]\nname = 'X'\nvelocity = 1\n";
  const Row rows[] = {
      {head + "colour = 1\n" + x, "m.toml:2: a machine has no key colour"},
      {x, "m.toml: a machine needs a name"},
      {head, "m.toml: a machine has 1 to 8 [[axis]] tables"},
      {head + x + "shade = 1\n", "m.toml:5: an axis has no key shade"},
      {head + x + x, "m.toml:5: axis X stands twice"},
      {head + "[[axis]]\nname = 'X'\n", "m.toml:2: an axis needs its velocity"},
      {head + x + "rotary = 1\n", "m.toml:5: rotary must be true or false"},
      {head + x + "travel = [1]\n", "m.toml:5: travel takes 2 numbers"},
      {head + x + "travel = [1, 'a']\n", "m.toml:5: travel takes 2 numbers"},
      {head + x + "travel = [5, 5]\n", "m.toml:5: travel takes its lower end first"},
      {head + x + "reference = [0, 0, 0, inf]\n", "m.toml:5: reference takes 4 numbers"},
      {head + x + "steps_per_unit = '100'\n",
       "m.toml:5: steps_per_unit must be a number other than 0"},
      {head + "[kinematics]\ntype = 'hexapod'\n" + x, "m.toml:3: there is no kinematics hexapod"},
      {head + "[kinematics]\ntype = 5\n" + x, "m.toml:3: there is no kinematics of this type"},
      {head + "kinematics = 5\n" + x, "m.toml:2: kinematics must be a table"},
      {head + "[kinematics]\nr_b = 5\n" + x, "m.toml:3: there is no key kinematics.r_b"},
      {head + "[kinematics]\nr_a = 5\n" + x,
       "m.toml:3: a machine of the type cartesian has no key kinematics.r_a"},
      {head + "[tip]\nvelocity = 5\n" + x,
       "m.toml:3: a machine of the type cartesian has no key tip.velocity"},
      {head + "[interpolator]\nmode = 1\n" + x,
       "m.toml:3: mode must be planned, tail, equal or literal"},
      {head + "[drive]\nhidden_tick = 'true'\n" + x, "m.toml:3: hidden_tick must be true or false"},
      {head + "[drive]\nwidth = 1\n" + x, "m.toml:3: there is no key drive.width"},
      {head + x + "[control]\noverrun = 1\n",
       "m.toml:6: parameter overrun=1: it belongs to an axis: overrun.X is that of X"},
      {head + x + "[control]\nCRE = { X = 1 }\n",
       "m.toml:6: parameter CRE.X=1: it does not belong to an axis"},
      {head + x + "[control]\noverrun = { W = 1 }\n",
       "m.toml:6: parameter overrun.W=1: the machine has no axis W"},
      {head + x + "[control]\noverrun = { X = 1001 }\n",
       "m.toml:6: parameter overrun.X=1001: a number from -1000 to 1000 is expected"},
      {head + "[kinematics]\ntype = 'arm'\n" + x,
       "m.toml:2: this kinematics has the axes rotary, rotary, rotary, linear, not linear"},
  };
  for (const Row& row : rows) EXPECT_EQ(refusal(row.toml), row.said);
}

TEST(MachineFile, AParameterMayHaveAValueForEachAxis) {
  const auto machine = MachineDefinition::parse(
      "name = 'm'\n" + axis("X") + axis("Y") + "[control]\noverrun = { X = 0.5, Y = -2 }\n",
      "m.toml");
  ASSERT_TRUE(machine) << machine.error().message;
  EXPECT_EQ(machine->parameters.overrun['X'], 0.5);
  EXPECT_EQ(machine->parameters.overrun['Y'], -2);
  EXPECT_EQ(machine->parameters.overrun['Z'], 0);
}

TEST(MachineFile, JointNamesAreForLinkagesWithATipOfTheirOwn) {
  const std::string said =
      "m.toml:2: an axis needs a name: one of X Y Z A B C U V W, or on linkages of the type arm or "
      "x-theta-z one of T1 T2 T3";
  for (const char* const name : {"T1", "T4", "XY", "", "x", "E"}) {
    EXPECT_EQ(refusal("name = 'm'\n" + axis(name)), said) << name;
  }
  const MachineDefinition machine = machine_of("arm");
  EXPECT_EQ(machine.driven[0].name, "T1");
  EXPECT_NE(refusal("name = 'm'\nkinematics.type = 'arm'\n" + axis("T4", true)), "");
}

}  // namespace
}  // namespace kerf::machine
