// X-θ-Z machine: tables of worked values, X1 = 25 mm, θ0 = 10 degrees, Z0 = 5 mm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"
#include "kinematics_machines.hpp"

namespace kerf::kinematics {
namespace {

using base::AxisVector;
using base::JointPoint;
using base::TipPoint;

constexpr double kPrinted = 0.5000001e-6;  // six decimals

void expect_near(const AxisVector& value, const AxisVector& expected) {
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(value.values[i], expected.values[i], kPrinted) << test::text(expected);
  }
}

TEST(KinematicsXThetaZ, TipAndJointsAreThoseOfTheTable) {
  struct Row {
    JointPoint joints;
    TipPoint tip;
    AxisVector inverse;
  };
  const Row rows[] = {
      {{{75, 20, 3}}, {{86.602540, 50, 8}}, {{75, 20, 3}}},
      {{{75, 110, 3}}, {{-50, 86.602540, 8}}, {{75, 110, 3}}},
      {{{75, 170, -2}}, {{-100, 0, 3}}, {{75, 170, -2}}},
      {{{75, -100, 0}}, {{0, -100, 5}}, {{75, -100, 0}}},
      {{{0, 0, 0}}, {{24.620194, 4.341204, 5}}, {{0, 0, 0}}},
      {{{-20, 35, 1}}, {{3.535534, 3.535534, 6}}, {{-20, 35, 1}}},
      {{{125.5, 260, 4.25}}, {{0, -150.5, 9.25}}, {{125.5, -100, 4.25}}},
  };
  const auto machine = test::make(test::x_theta_z_settings());
  for (const Row& row : rows) {
    const TipPoint tip = machine->forward(row.joints);
    expect_near(tip, row.tip);
    expect_near(*machine->inverse(tip, {}), row.inverse);
    expect_near(*machine->inverse(tip, row.joints), row.joints);
  }
}

TEST(KinematicsXThetaZ, FromPointToPointTheTurnIsKept) {
  struct Row {
    TipPoint tip;
    JointPoint joints;
    AxisVector step;
    double duration_s;
  };
  const Row rows[] = {
      {{{60, 0, 0}}, {{35, -10, -5}}, {{35, -10, -5}}, 0.5},
      {{{0, 60, 0}}, {{35, 80, -5}}, {{0, 90, 0}}, 1},
      {{{-50, 20, 0}}, {{28.851648, 148.198591, -5}}, {{-6.148352, 68.198591, 0}}, 0.757762},
      {{{-40, -30, 0}}, {{25, 206.869898, -5}}, {{-3.851648, 58.671307, 0}}, 0.651903},
      {{{30, -45, 0}}, {{29.083269, 293.690068, -5}}, {{4.083269, 86.820170, 0}}, 0.964669},
  };
  const auto machine = test::make(test::x_theta_z_settings());
  JointPoint at;
  for (const Row& row : rows) {
    const JointPoint next = *machine->inverse(row.tip, at);
    const AxisVector step = next - at;
    expect_near(next, row.joints);
    expect_near(step, row.step);
    // 100 mm/s, 90 degrees/s, 10 mm/s: all axes start and stop together.
    EXPECT_NEAR(std::max({std::fabs(step.values[0]) / 100, std::fabs(step.values[1]) / 90,
                          std::fabs(step.values[2]) / 10}),
                row.duration_s, kPrinted);
    at = next;
  }
}

TEST(KinematicsXThetaZ, OnTheAxisTheAngleStays) {
  const auto machine = test::make(test::x_theta_z_settings());
  const JointPoint joints = *machine->inverse({{0.9e-9, 0, 0}}, {{0, 123, 0}});
  EXPECT_EQ(joints.values[1], 123);
  const auto rates = machine->along({{}, {{1, 0, 0}}, {}, {}}, joints);
  ASSERT_FALSE(rates);
  EXPECT_EQ(rates.error().kind, Fault::Kind::singular);
}

// Past the axis at the distance d, s from the nearest point: r = √(d² + s²), θ = atan(s / d).
TEST(KinematicsXThetaZ, AlongALineThatPassesTheAxisTheJointsMoveAsCalculusSays) {
  const auto machine = test::make(test::x_theta_z_settings());
  const double d = 40;
  for (const double s : {-300.0, -20.0, 0.0, 1.0, 35.0, 1000.0}) {
    const TipPoint tip{{d, s, 12}};
    const JointPoint joints = *machine->inverse(tip, {});
    const auto jet = *machine->along({tip, {{0, 1, 0}}, {}, {}}, joints);
    const double r = std::hypot(d, s);
    const double turn = geometry::degrees(1);
    EXPECT_EQ(jet.value, joints);
    expect_near(jet.first, {{s / r, turn * d / std::pow(r, 2), 0}});
    expect_near(jet.second, {{d * d / std::pow(r, 3), -2 * turn * d * s / std::pow(r, 4), 0}});
    expect_near(jet.third, {{-3 * d * d * s / std::pow(r, 5),
                             2 * turn * d * (3 * s * s - d * d) / std::pow(r, 6), 0}});
  }
}

TEST(KinematicsXThetaZ, CarriageBeyondItsLimitIsNamed) {
  auto settings = test::x_theta_z_settings();
  settings.joints[0].low = 0;
  settings.joints[0].high = 200;
  const auto joints = test::make(settings)->inverse({{3, 4, 0}}, {});
  ASSERT_FALSE(joints);
  EXPECT_EQ(joints.error().message, "X would stand at -20 mm, beyond its limit of 0 mm");
}

}  // namespace
}  // namespace kerf::kinematics
