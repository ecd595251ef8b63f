// A/C laser head: tables of worked values, r_a = 150 mm, r_c = 80 mm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/deviation.hpp"
#include "kinematics/orientation.hpp"
#include "kinematics_machines.hpp"

namespace kerf::kinematics {
namespace {

using base::AxisVector;
using base::JointPoint;
using base::TipPoint;
using geometry::Vec3;

constexpr double kPrinted = 0.5000001e-6;   // six decimals
constexpr double kPrinted9 = 0.5000001e-9;  // nine

Vec3 focus(const TipPoint& tip) { return {tip.values[0], tip.values[1], tip.values[2]}; }

TEST(KinematicsHead, CarriageStandsWhereTheTableSays) {
  struct Row {
    TipPoint tip;
    Vec3 carriage;
    Vec3 beam;
  };
  const Row rows[] = {
      {{{0, 0, 0, 0, 0}}, {-80, 0, 150}, {0, 0, 1}},
      {{{100, 50, 25, 30, 90}}, {175, -30, 154.903811}, {0.5, 0, 0.866025}},
      {{{10, 20, 30, -45, 10}},
       {-87.202791, 110.562782, 136.066017},
       {-0.122788, 0.696364, 0.707107}},
      {{{10, 20, 30, 45, 190}},
       {70.366450, 138.346490, 136.066017},
       {-0.122788, 0.696364, 0.707107}},
      {{{-12.5, 7.25, 3, 90, 0}}, {-92.5, -142.75, 3}, {0, -1, 0}},
      {{{0, 0, 0, 15, -120}}, {6.378420, 88.693461, 144.888874}, {-0.224144, 0.129410, 0.965926}},
      {{{200, -80, 60, 62.5, 233.1}},
       {141.634275, 63.861659, 129.262292},
       {-0.709329, 0.532579, 0.461749}},
  };
  const auto head = test::make(test::head_settings());
  for (const Row& row : rows) {
    const auto joints = head->inverse(row.tip, {});
    ASSERT_TRUE(joints);
    EXPECT_NEAR(joints->values[0], row.carriage.x, kPrinted) << test::text(row.tip);
    EXPECT_NEAR(joints->values[1], row.carriage.y, kPrinted) << test::text(row.tip);
    EXPECT_NEAR(joints->values[2], row.carriage.z, kPrinted) << test::text(row.tip);
    EXPECT_EQ(joints->values[3], row.tip.values[3]);
    EXPECT_EQ(joints->values[4], row.tip.values[4]) << "the program's own turn";
    const TipPoint back = head->forward(*joints);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(back.values[i], row.tip.values[i], 1e-12);
    const Vec3 beam = beam_axis({row.tip.values[3], row.tip.values[4]});
    EXPECT_NEAR(beam.x, row.beam.x, kPrinted);
    EXPECT_NEAR(beam.y, row.beam.y, kPrinted);
    EXPECT_NEAR(beam.z, row.beam.z, kPrinted);
  }
}

TEST(KinematicsHead, OrientationIsThatOfTheTable) {
  struct Row {
    Vec3 normal;
    HeadAngles previous;
    HeadAngles expected;
  };
  const Row rows[] = {
      {{0, 0, 1}, {0, 33}, {0, 33}},
      {{1, 0, 1}, {0, 0}, {45, 90}},
      {{0, -1, 1}, {0, 0}, {45, 0}},
      {{0, 1, 1}, {0, 0}, {-45, 0}},
      {{0, 1, 1}, {-10, 0}, {-45, 0}},
      {{1, 2, 3}, {0, 0}, {-36.699225, -26.565051}},
      {{-1, 2, 0.5}, {0, 350}, {-77.395617, 386.565051}},
      {{1e-10, 0, 1}, {5, 77}, {0, 77}},
      {{0, 0, -1}, {0, 10}, {180, 10}},
      {{0.3, -0.4, -0.2}, {0, 0}, {111.801409, 36.869898}},
  };
  for (const Row& row : rows) {
    const auto angles = orientation(row.normal, row.previous);
    ASSERT_TRUE(angles);
    EXPECT_NEAR(angles->a_deg, row.expected.a_deg, kPrinted) << row.normal.x << " " << row.normal.y;
    EXPECT_NEAR(angles->c_deg, row.expected.c_deg, kPrinted) << row.normal.x << " " << row.normal.y;
  }
}

TEST(KinematicsHead, ANormalWithoutLengthHasNoOrientation) {
  const auto angles = orientation({0, 0, 0}, {});
  ASSERT_FALSE(angles);
  EXPECT_EQ(angles.error().kind, Fault::Kind::singular);
  EXPECT_EQ(name_of(angles.error().kind), "SINGULAR");
}

TEST(KinematicsHead, ADownwardBeamStaysOnTheSideOfThePreviousTilt) {
  EXPECT_EQ(orientation({0, 0, -1}, {-170, 10})->a_deg, -180);
  EXPECT_EQ(orientation({0, 0, -1}, {170, 10})->a_deg, 180);
}

/// Largest distance of the focus from the point of the same share on the straight line, in a step
/// of the angles about which the carriage moves straight.
double largest_focus_error(const Kinematics& head, HeadAngles from, HeadAngles delta) {
  const TipPoint begin{{0, 0, 0, from.a_deg, from.c_deg}};
  const TipPoint end{{0, 0, 0, from.a_deg + delta.a_deg, from.c_deg + delta.c_deg}};
  const JointPoint from_joints = *head.inverse(begin, {});
  const JointPoint to_joints = *head.inverse(end, from_joints);
  double most = 0;
  constexpr int kSamples = 10'000;
  for (int i = 0; i <= kSamples; ++i) {
    const double share = i / double{kSamples};
    JointPoint joints;
    for (std::size_t k = 0; k < 5; ++k) {
      joints.values[k] =
          from_joints.values[k] + share * (to_joints.values[k] - from_joints.values[k]);
    }
    most = std::max(most, length(focus(head.forward(joints))));
  }
  return most;
}

TEST(KinematicsHead, FocusLeavesTheLineAsTheTableSays) {
  struct Row {
    HeadAngles from;
    HeadAngles delta;
    double error;
    double bound;
  };
  const Row rows[] = {
      {{0, 0}, {0.5, 0}, 0.001427892, 0.001427894},
      {{30, 0}, {0.5, 0}, 0.001427892, 0.001427894},
      {{30, 45}, {0, 0.5}, 0.001043870, 0.002189438},
      {{30, 45}, {0.5, 0.5}, 0.003743544, 0.006473120},
      {{60, 10}, {1, 2}, 0.034275099, 0.063588886},
      {{90, 0}, {0.1, 0.2}, 0.000310408, 0.000635889},
  };
  const auto head = test::make(test::head_settings());
  for (const Row& row : rows) {
    EXPECT_NEAR(largest_focus_error(*head, row.from, row.delta), row.error, kPrinted9);
    EXPECT_NEAR(head_deviation_mm({}, row.delta.a_deg, row.delta.c_deg), row.bound, kPrinted9);
  }
}

TEST(KinematicsHead, TurnedOverHoldsTheSameFocusAndBeam) {
  const auto head = test::make(test::head_settings());
  const TipPoint tip{{10, 20, 30, -45, 10}};
  EXPECT_EQ(head->branch_at(JointPoint(tip.numbers())), Branch::minus);
  const AxisVector over = *head->inverse(tip, {}, Branch::plus);
  EXPECT_NEAR(over.values[0], 70.366450, kPrinted);
  EXPECT_NEAR(over.values[3], 45, 1e-12);
  EXPECT_NEAR(over.values[4], -170, 1e-12) << "190 on the turn nearest to 0";
}

TEST(KinematicsHead, NearestTakesTheBranchThatIsWithinTheLimits) {
  auto settings = test::head_settings();
  settings.joints[3].low = -10;
  settings.joints[3].high = 100;
  const auto head = test::make(settings);
  const TipPoint tip{{0, 0, 0, -45, 10}};
  EXPECT_EQ(head->inverse(tip, {}).error().kind, Fault::Kind::limit);
  EXPECT_NEAR(head->nearest(tip, {})->values[3], 45, 1e-12);
  EXPECT_NEAR(head->nearest(tip, {})->values[4], -170, 1e-12);
}

}  // namespace
}  // namespace kerf::kinematics
