#include <gtest/gtest.h>

#include <limits>

#include "kinematics_machines.hpp"

namespace kerf::kinematics {
namespace {

using base::TipPoint;

std::string refusal(const Settings& settings) {
  const auto made = make_kinematics(settings);
  return made ? "" : made.error().message;
}

TEST(KinematicsSettings, WordsOfMachineFilesNameKinds) {
  EXPECT_EQ(kind_named("cartesian"), Kind::cartesian);
  EXPECT_EQ(kind_named("cartesian-step"), Kind::cartesian);
  EXPECT_EQ(kind_named("x-theta-z"), Kind::x_theta_z);
  EXPECT_EQ(kind_named("head-ac"), Kind::head_ac);
  EXPECT_EQ(kind_named("arm"), Kind::arm);
  EXPECT_FALSE(kind_named("Arm"));
}

TEST(KinematicsSettings, JointsMustBeThoseOfTheKind) {
  auto settings = test::arm_settings();
  std::swap(settings.joints[2], settings.joints[3]);
  EXPECT_EQ(refusal(settings),
            "this kinematics has the axes rotary, rotary, rotary, linear, not rotary, rotary, "
            "linear, rotary");
  settings = test::head_settings();
  settings.joints.pop_back();
  EXPECT_NE(refusal(settings), "");
  settings = test::cartesian_settings();
  settings.joints.resize(base::kMaxAxes + 1);
  EXPECT_EQ(refusal(settings), "a machine has 1 to 8 axes, not 9");
  settings.joints.clear();
  EXPECT_EQ(refusal(settings), "a machine has 1 to 8 axes, not 0");
}

TEST(KinematicsSettings, LengthsAndRangesMustBePossible) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  auto settings = test::arm_settings();
  settings.arm.forearm_mm = 0;
  EXPECT_EQ(refusal(settings), "the upper arm and the forearm need lengths above 0");
  settings = test::head_settings();
  settings.head.r_a_mm = kNone;
  EXPECT_EQ(refusal(settings), "a length or angle of the kinematics is not a finite number");
  settings = test::head_settings();
  settings.joints[3].low = 10;
  settings.joints[3].high = -10;
  EXPECT_EQ(refusal(settings), "the range of A is empty");
  settings.joints[3].high = kNone;
  EXPECT_EQ(refusal(settings), "the range of A is empty");
}

TEST(KinematicsCartesian, JointsAreTheTip) {
  const auto machine = test::make(test::cartesian_settings());
  const TipPoint tip{{1, -2, 3, 770}};
  const base::JointPoint joints(tip.numbers());
  EXPECT_EQ(machine->forward(joints), tip);
  EXPECT_EQ(*machine->inverse(tip, {}), joints);
  EXPECT_EQ(*machine->nearest(tip, {}), joints);
  const base::TipJet path{tip, {{1, 0, 2}}, {{0, 5}}, {{-7}}};
  EXPECT_EQ(*machine->along(path, joints),
            (base::JointJet{joints, path.first, path.second, path.third}));
  EXPECT_EQ(machine->deviation_bound_mm({}, joints), 0);
  EXPECT_FALSE(machine->has_branches());
}

}  // namespace
}  // namespace kerf::kinematics
