#include "stock/sweep/turning_steps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kerf::stock {
namespace {

using std::numbers::pi;

/// About a point `lever` above the tip, in the plane X = 0.
ToolPose swing(double angle, double lever) {
  const Vec3 axis{0, -std::sin(angle), std::cos(angle)};
  return {Vec3{} - lever * axis, axis};
}

double off(const TurningStep& step, double lever, const ToolPose& pose, double t) {
  const Vec3 chord_tip = step.way.from + t * (step.way.to - step.way.from);
  const Vec3 chord_axis = step.axis + t * (step.way.to_axis - step.axis);
  const Vec3 d = pose.tip + lever * pose.axis - (chord_tip + lever * chord_axis);
  return std::sqrt(dot(d, d));
}

TEST(TurningSteps, LeaveTheTrueWayByTheToleranceAtMost) {
  for (const double lever : {0.0, 4.0, 40.0}) {
    const auto pose = [](double t) { return swing(pi / 3 * t, 4); };
    const auto steps = turning_steps(pose, lever, 0.002);
    const double count = static_cast<double>(steps.size());
    double i = 0;
    for (const TurningStep& step : steps) {
      const double turn =
          2 *
          std::asin(std::sqrt(dot(step.way.to_axis - step.axis, step.way.to_axis - step.axis)) / 2);
      EXPECT_LE(turn, std::sqrt(8 * 0.002 / std::max(lever, 0.002)) * 1.001);
      for (const double share : {0.2, 0.5, 0.9}) {
        EXPECT_LE(off(step, lever, pose((i + share) / count), share), 0.002) << lever;
        EXPECT_LE(off(step, 0, pose((i + share) / count), share), 0.002) << lever;
      }
      ++i;
    }
  }
}

TEST(TurningSteps, JoinExactlyAndEndWhereTheWayDoes) {
  const auto pose = [](double t) { return swing(2 * pi * t, 10); };
  const auto steps = turning_steps(pose, 10, 0.01);
  EXPECT_GE(steps.size(), 32U);
  EXPECT_EQ(steps.front().axis, pose(0).axis);
  EXPECT_EQ(steps.back().way.to, pose(1).tip);
  for (std::size_t i = 1; i < steps.size(); ++i) {
    EXPECT_EQ(steps[i].axis, steps[i - 1].way.to_axis);
    EXPECT_EQ(steps[i].way.from, steps[i - 1].way.to);
  }
}

TEST(TurningSteps, AreBoundedWhateverTheWay) {
  double calls = 0;
  const auto wild = [&](double t) {
    ++calls;
    return swing(1e6 * std::sin(1e5 * t), 1e3);
  };
  EXPECT_LE(turning_steps(wild, 1e9, 1e-9).size(), 1U << 16);
  EXPECT_LE(calls, 1e6);
}

}  // namespace
}  // namespace kerf::stock
