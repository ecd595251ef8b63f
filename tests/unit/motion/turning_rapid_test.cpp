// Rapids from point to point over turning work, against the worked table of the lens machine and
// the equations of the linkage.
#include "motion/turning_rapid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "motion/motion_extent.hpp"
#include "motion/move_curves.hpp"
#include "motion_axes.hpp"
#include "seeded_random.hpp"

namespace kerf::motion {
namespace {

using base::TipPoint;
using test::SeededRandom;

AxisSetup lens_machine() {
  AxisSetup axes = test::axes_named("XYZ", 6000);
  axes.axes[2].rapid_per_min = 600;
  axes.turning_work = {6000, 5400};
  return axes;
}

double radius(const TipPoint& tip) { return std::hypot(tip.values[0], tip.values[1]); }
double angle_deg(const TipPoint& tip) {
  return std::atan2(tip.values[1], tip.values[0]) * 180 / std::numbers::pi;
}
double turned_deg(double from, double to) { return std::remainder(to - from, 360); }

Motion rapid_to(const TipPoint& to) {
  Motion motion;
  motion.action = Rapid{to, true};
  return motion;
}

TipPoint random_tip(SeededRandom& random) {
  return {{random.in(-90, 90), random.in(-90, 90), random.in(-20, 20)}};
}

// 100 mm/s, 90 degrees/s, 10 mm/s; the carriage is 25 mm from the axis, the work at 10 degrees, the
// focus 5 mm up.
TEST(TurningRapid, TakesTheTimeOfTheSlowestAxis) {
  const AxisSetup axes = lens_machine();
  const double zero_rad = 10 * std::numbers::pi / 180;
  TipPoint at{{25 * std::cos(zero_rad), 25 * std::sin(zero_rad), 5}};
  const std::pair<TipPoint, double> table[] = {{{{60, 0, 0}}, 0.5},
                                               {{{0, 60, 0}}, 1},
                                               {{{-50, 20, 0}}, 0.757762},
                                               {{{-40, -30, 0}}, 0.651903},
                                               {{{30, -45, 0}}, 0.964669}};
  for (const auto& [to, seconds] : table) {
    EXPECT_NEAR(TurningRapid::seconds(axes, at, to), seconds, 5e-7);
    at = to;
  }
}

TEST(TurningRapid, RadiusAngleAndHeightGoInProportion) {
  const AxisSetup axes = lens_machine();
  SeededRandom random(test::kSeed);
  for (int i = 0; i < 2000; ++i) {
    const TipPoint from = random_tip(random);
    const TipPoint to = random_tip(random);
    const auto way = TurningRapid::between(axes, from, to);
    ASSERT_TRUE(way);
    const Curve curve = way->curve();
    EXPECT_EQ(curve.end(), to);
    const double turn = turned_deg(angle_deg(from), angle_deg(to));
    for (const double share : {0.0, 0.1, 0.5, 0.77}) {
      const TipPoint at = curve.at(share * curve.length());
      EXPECT_NEAR(radius(at), radius(from) + share * (radius(to) - radius(from)), 1e-9);
      EXPECT_NEAR(turned_deg(angle_deg(from), angle_deg(at)), share * turn, 1e-6);
      EXPECT_NEAR(at.values[2], from.values[2] + share * (to.values[2] - from.values[2]), 1e-9);
    }
  }
}

TEST(TurningRapid, LengthAndExtentAreThoseOfManyChords) {
  const AxisSetup axes = lens_machine();
  SeededRandom random(test::kSeed + 1);
  constexpr int kChords = 20'000;
  for (int i = 0; i < 40; ++i) {
    const TipPoint from = random_tip(random);
    const TipPoint to = random_tip(random);
    const auto way = TurningRapid::between(axes, from, to);
    ASSERT_TRUE(way);
    const Curve curve = way->curve();
    MotionExtent chords{to, to};
    double length = 0;
    TipPoint before = from;
    for (int n = 1; n <= kChords; ++n) {
      const TipPoint at = curve.at(curve.length() * n / kChords);
      const base::AxisVector step = at - before;
      length += std::hypot(step.values[0], step.values[1], step.values[2]);
      chords.reach(at);
      before = at;
    }
    EXPECT_NEAR(way->length_mm(), length, 1e-6 * length);
    MotionExtent extent = extent_of(axes, from, rapid_to(to));
    extent.reach(from);  // which is no part of it
    chords.reach(from);
    for (std::size_t m = 0; m < 3; ++m) {
      EXPECT_NEAR(extent.low.values[m], chords.low.values[m], 1e-4);
      EXPECT_NEAR(extent.high.values[m], chords.high.values[m], 1e-4);
    }
  }
}

TEST(TurningRapid, TowardsTheAxisAndFromItIsStraight) {
  const AxisSetup axes = lens_machine();
  EXPECT_FALSE(TurningRapid::between(axes, {{30, 40, 0}}, {{0, 0, 0}}));
  EXPECT_FALSE(TurningRapid::between(axes, {{0, 0, 0}}, {{30, 40, 5}}));
  EXPECT_FALSE(TurningRapid::between(axes, {{30, 40, 0}}, {{60, 80, 3}}));
  EXPECT_NEAR(TurningRapid::seconds(axes, {{30, 40, 0}}, {{60, 80, 3}}), 0.5, 1e-12);
}

TEST(TurningRapid, HalfATurnIsClockwise) {
  const AxisSetup axes = lens_machine();
  const auto way = TurningRapid::between(axes, {{10, 0, 0}}, {{-10, 0, 0}});
  ASSERT_TRUE(way);
  EXPECT_LT(way->curve().at(way->curve().length() / 2).values[1], -9.9);
}

TEST(TurningRapid, IsTheWayOfEveryRapidOfTheMachineAndOfNothingElse) {
  AxisSetup axes = lens_machine();
  MoveCurves curves(axes);
  Motion nonlinear = rapid_to({{0, 60, 0}});
  std::get<Rapid>(nonlinear.action).linear = false;
  for (const Motion& motion : {rapid_to({{0, 60, 0}}), nonlinear}) {
    const auto made = curves.of({{60, 0, 0}}, motion);
    ASSERT_EQ(made.size(), 1U);
    EXPECT_TRUE(made.front().is_arc());
  }
  Motion line;
  line.action = Line{{{0, 60, 0}}, {600, FeedMode::per_minute}};
  EXPECT_TRUE(curves.of({{60, 0, 0}}, line).front().is_line());
  axes.turning_work.reset();
  EXPECT_TRUE(curves.of({{60, 0, 0}}, rapid_to({{0, 60, 0}})).front().is_line());
}

}  // namespace
}  // namespace kerf::motion
