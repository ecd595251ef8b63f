// Two-link arm: tables of worked values, both links 132 mm, 0.005 degrees a pulse.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angle.hpp"
#include "kinematics/deviation.hpp"
#include "kinematics_machines.hpp"

namespace kerf::kinematics {
namespace {

using base::AxisVector;
using base::JointPoint;
using base::TipPoint;

constexpr double kPrinted = 0.5000001e-6;  // six decimals
constexpr double kPulse_deg = 0.005;

double pulses(double angle_deg) { return std::round(angle_deg / kPulse_deg); }

/// Determinant of d(x, y) / d(θ2, θ1), mm², positive with the elbow +, from the derivatives of the
/// inverse along X and Y.
double determinant(const Kinematics& arm, const JointPoint& joints) {
  const TipPoint tip = arm.forward(joints);
  const AxisVector x = arm.along({tip, {{1, 0}}, {}, {}}, joints)->first;
  const AxisVector y = arm.along({tip, {{0, 1}}, {}, {}}, joints)->first;
  const double inverse = x.values[1] * y.values[0] - y.values[1] * x.values[0];
  return 1 / (inverse * std::pow(std::numbers::pi / 180, 2));
}

TEST(KinematicsArm, TipStandsWhereTheTableSays) {
  struct Row {
    double t1, t2, x, y, r, det;
  };
  const Row rows[] = {
      {0, 0, 264, 0, 264, 0},
      {90, 0, 132, 132, 186.676190, 17424},
      {-90, 90, 132, 132, 186.676190, -17424},
      {60, -30, 228.630707, 0, 228.630707, 15089.6266},
      {120, 45, -34.164114, 127.502209, 132, 15089.6266},
      {179.5, 0, 0.005026, 1.151903, 1.151914, 152.0512},
      {30, 170, -254.034049, -22.225099, 255.004418, 8712},
      {-45, -100, -131.049629, -205.706713, 243.904197, -12320.6286},
  };
  const auto arm = test::make(test::arm_settings());
  for (const Row& row : rows) {
    const JointPoint joints{{row.t1, row.t2, 0, 0}};
    const TipPoint tip = arm->forward(joints);
    EXPECT_NEAR(tip.values[0], row.x, kPrinted);
    EXPECT_NEAR(tip.values[1], row.y, kPrinted);
    EXPECT_NEAR(std::hypot(tip.values[0], tip.values[1]), row.r, kPrinted);
    if (row.det != 0) {
      EXPECT_NEAR(determinant(*arm, joints), row.det, 0.5000001e-4);
    }
  }
}

TEST(KinematicsArm, BothElbowsAreThoseOfTheTable) {
  struct Row {
    double x, y, plus_t1, plus_t2, minus_t1, minus_t2, pulses_t1, pulses_t2;
  };
  const Row rows[] = {
      {264, 0, 0, 0, 0, 0, 0, 0},
      {132, 132, 90, 0, -90, 90, 18000, 0},
      {200, 50, 77.315506, -24.621510, -77.315506, 52.693997, 15463, -4924},
      {0, 100, 135.482757, 22.258621, -135.482757, 157.741379, 27097, 4452},
      {-150, -80, 99.827597, -201.841312, -99.827597, -102.013714, 19966, -40368},
      {10, 0, 175.658372, -87.829186, -175.658372, 87.829186, 35132, -17566},
      {180, -120, 69.941756, -68.660946, -69.941756, 1.280811, 13988, -13732},
  };
  const auto arm = test::make(test::arm_settings());
  for (const Row& row : rows) {
    const TipPoint tip{{row.x, row.y}};
    const auto plus = arm->inverse(tip, {{0, row.plus_t2}}, Branch::plus);
    const auto minus = arm->inverse(tip, {{0, row.minus_t2}}, Branch::minus);
    ASSERT_TRUE(plus && minus);
    EXPECT_NEAR(plus->values[0], row.plus_t1, kPrinted);
    EXPECT_NEAR(plus->values[1], row.plus_t2, kPrinted);
    EXPECT_NEAR(minus->values[0], row.minus_t1, kPrinted);
    EXPECT_NEAR(minus->values[1], row.minus_t2, kPrinted);
    EXPECT_EQ(pulses(plus->values[0]), row.pulses_t1);
    EXPECT_EQ(pulses(plus->values[1]), row.pulses_t2);
  }
}

TEST(KinematicsArm, WheelKeepsItsHeadingByHalfTurns) {
  const auto arm = test::make(test::arm_settings());
  const JointPoint previous{{90, 0, 80, 0}};
  const JointPoint joints = *arm->inverse({{132, 132, 7, 0}}, previous);
  EXPECT_NEAR(joints.values[2], 90, 1e-9) << "0 - 90 - 0, half a turn on";
  EXPECT_EQ(joints.values[3], 7);
}

TEST(KinematicsArm, AbsoluteForearmCountsFromX) {
  auto settings = test::arm_settings();
  settings.arm.forearm_absolute = true;
  const auto arm = test::make(settings);
  const JointPoint joints = *arm->inverse({{132, 132, 0, 90}}, {{0, 60}}, Branch::minus);
  EXPECT_NEAR(joints.values[0], 0, 1e-9);
  EXPECT_NEAR(joints.values[1], 90, 1e-9);
  EXPECT_NEAR(joints.values[2], -90, 1e-9) << "or 90: the wheel is the same after half a turn";
  EXPECT_EQ(arm->branch_at(joints), Branch::minus);
}

TEST(KinematicsArm, TheStretchedArmBendsToTheSideOfItsElbow) {
  auto settings = test::arm_settings();
  for (const bool minus : {false, true}) {
    settings.arm.elbow_minus = minus;
    const auto arm = test::make(settings);
    const double sign = minus ? -1 : 1;
    const JointPoint joints = *arm->inverse({{200, 50}}, {});
    EXPECT_NEAR(joints.values[0], sign * 77.315506, 1e-6);
    EXPECT_EQ(arm->branch_at(joints), minus ? Branch::minus : Branch::plus);
    // Once bent it stays.
    EXPECT_NEAR(arm->inverse({{132, 132}}, {{-sign, 0}})->values[0], -sign * 90, 1e-9);
  }
}

TEST(KinematicsArm, BeyondTheLinksIsOutOfReach) {
  const auto arm = test::make(test::arm_settings());
  EXPECT_TRUE(arm->inverse({{264 + 0.9e-9, 0}}, {}));
  const auto joints = arm->inverse({{264, 10}}, {});
  ASSERT_FALSE(joints);
  EXPECT_EQ(name_of(joints.error().kind), "OUT_OF_REACH");
  EXPECT_EQ(
      joints.error().message,
      "the tip X264 Y10 is 264.189326 mm from the shoulder; the arm reaches from 0 to 264 mm");
  EXPECT_FALSE(arm->nearest({{264, 10}}, {}));

  auto settings = test::arm_settings();
  settings.arm.forearm_mm = 100;
  EXPECT_EQ(test::make(settings)->inverse({{31, 0}}, {}).error().kind, Fault::Kind::out_of_reach);
}

TEST(KinematicsArm, AJointBeyondItsLimitIsNamed) {
  auto settings = test::arm_settings();
  settings.joints[0].low = -163.835;
  settings.joints[0].high = 163.835;
  settings.joints[1].low = -180;
  settings.joints[1].high = 180;
  const auto arm = test::make(settings);
  const auto folded = arm->inverse({{10, 0}}, {});
  ASSERT_FALSE(folded);
  EXPECT_EQ(name_of(folded.error().kind), "LIMIT");
  EXPECT_EQ(folded.error().joint, base::Axis{0});
  EXPECT_NEAR(folded.error().value, 175.658372, kPrinted);
  EXPECT_EQ(folded.error().limit, 163.835);
  EXPECT_EQ(folded.error().message,
            "T1 would stand at 175.658372 degrees, beyond its limit of 163.835 degrees");

  // Along a path the turn is kept; a move off the work may go round.
  const JointPoint previous{{100, -175}};
  const TipPoint tip{{-150, -80}};
  EXPECT_EQ(arm->inverse(tip, previous).error().joint, base::Axis{1});
  EXPECT_NEAR(arm->nearest(tip, previous)->values[1], -102.013714, kPrinted) << "the other elbow";
  EXPECT_NEAR(arm->inverse(tip, {{100, 0}})->values[1], 158.158688, kPrinted);
}

TEST(KinematicsArm, NearestGoesRoundWhenTheOtherElbowIsBeyondItsLimit) {
  auto settings = test::arm_settings();
  settings.joints[0].low = 0;
  settings.joints[0].high = 163.835;
  settings.joints[1].low = -180;
  settings.joints[1].high = 180;
  const auto joints = test::make(settings)->nearest({{-150, -80}}, {{100, -175}});
  ASSERT_TRUE(joints);
  EXPECT_NEAR(joints->values[1], 158.158688, kPrinted);
}

TEST(KinematicsArm, AtTheShoulderTheUpperArmStays) {
  const auto arm = test::make(test::arm_settings());
  const JointPoint joints = *arm->inverse({{0, 0}}, {{170, 33}});
  EXPECT_NEAR(joints.values[0], 180, 1e-9);
  EXPECT_EQ(joints.values[1], 33);
}

TEST(KinematicsArm, RatesAreSingularStretchedAndFolded) {
  const auto arm = test::make(test::arm_settings());
  for (const JointPoint& joints : {JointPoint{{0, 20}}, JointPoint{{180, 20}}}) {
    const auto rates = arm->along({arm->forward(joints), {{1, 0}}, {}, {}}, joints);
    ASSERT_FALSE(rates);
    EXPECT_EQ(rates.error().kind, Fault::Kind::singular);
    EXPECT_NE(rates.error().message.find(joints.values[0] == 0 ? "stretched" : "folded"),
              std::string::npos);
  }
}

TEST(KinematicsArm, CautionBelowASineOfFiveHundredths) {
  const auto arm = test::make(test::arm_settings());
  const double limit_deg = geometry::degrees(std::asin(0.05));
  for (const double off : {limit_deg, -limit_deg, 180 - limit_deg, limit_deg - 180}) {
    const double inward = std::fabs(off) < 90 ? 0.999 : 1.0001;
    EXPECT_TRUE(arm->caution({{off * inward, 5}})) << off;
    EXPECT_FALSE(arm->caution({{off / inward, 5}})) << off;
  }
}

TEST(KinematicsArm, ThirtyPulsesOfBothArmsLeaveTheLineByTheTermOfTheBound) {
  EXPECT_NEAR(arm_deviation_mm({}, 30 * kPulse_deg, 60 * kPulse_deg), 0.000565, kPrinted);
  EXPECT_NEAR(arm_rounding_mm({}, 264, kPulse_deg / 2), 0.017279, kPrinted);
}

struct Loop {
  AxisVector first_pulses;
  AxisVector last_pulses;
  double most_error_mm = 0;
};

/// A path of samples rounded to pulses and replayed with both joints in proportion.
template <typename Path, typename Error>
Loop replay(const Path& path, const Error& error, int segments, Branch branch) {
  const auto arm = test::make(test::arm_settings());
  Loop loop;
  JointPoint exact = *arm->inverse(path(0.0), {}, branch);
  JointPoint at;
  for (int i = 0; i <= segments; ++i) {
    exact = *arm->inverse(path(i / double(segments)), exact);
    JointPoint next;
    for (std::size_t k : {0U, 1U}) next.values[k] = pulses(exact.values[k]);
    if (i == 0) loop.first_pulses = at = next;
    for (int j = 0; j <= 20; ++j) {
      JointPoint joints;
      for (std::size_t k : {0U, 1U}) {
        joints.values[k] = kPulse_deg * (at.values[k] + j / 20.0 * (next.values[k] - at.values[k]));
      }
      loop.most_error_mm = std::max(loop.most_error_mm, error(arm->forward(joints)));
    }
    loop.last_pulses = at = next;
  }
  return loop;
}

TEST(KinematicsArm, ACircleEndsInThePulsesInWhichItBegan) {
  const auto path = [](double share) {
    return TipPoint{{150 + 25 * std::cos(2 * std::numbers::pi * share),
                     60 + 25 * std::sin(2 * std::numbers::pi * share)}};
  };
  const auto error = [](const TipPoint& tip) {
    return std::fabs(std::hypot(tip.values[0] - 150, tip.values[1] - 60) - 25);
  };
  const Loop loop = replay(path, error, 500, Branch::plus);
  EXPECT_EQ(loop.first_pulses, (AxisVector{{18205, -5318}}));
  EXPECT_EQ(loop.last_pulses, loop.first_pulses);
  // Steps of up to 35 pulses; samples are rounded, pulses between them come in proportion.
  EXPECT_LE(loop.most_error_mm, arm_rounding_mm({}, 187, kPulse_deg / 2) +
                                    arm_deviation_mm({}, 35 * kPulse_deg, 70 * kPulse_deg) +
                                    sampling_deviation_mm(2 * std::numbers::pi * 25 / 500, 25));
  EXPECT_LE(loop.most_error_mm, 0.0128);
}

TEST(KinematicsArm, ALineBeginsAndEndsInThePulsesOfTheTable) {
  const auto path = [](double share) { return TipPoint{{120 + 80 * share, -80 + 120 * share}}; };
  const auto error = [](const TipPoint& tip) {
    const double length = std::hypot(80, 120);
    return std::fabs((tip.values[0] - 120) * 120 - (tip.values[1] + 80) * 80) / length;
  };
  const Loop plus = replay(path, error, 450, Branch::plus);
  EXPECT_EQ(plus.first_pulses, (AxisVector{{22755, -18115}}));
  EXPECT_EQ(plus.last_pulses, (AxisVector{{15766, -5621}}));
  EXPECT_LE(plus.most_error_mm, 0.0107);
  const Loop minus = replay(path, error, 450, Branch::minus);
  EXPECT_EQ(minus.first_pulses, (AxisVector{{-22755, 4639}}));
  EXPECT_EQ(minus.last_pulses, (AxisVector{{-15766, 10145}}));
  EXPECT_LE(minus.most_error_mm, 0.0096);
}

}  // namespace
}  // namespace kerf::kinematics
