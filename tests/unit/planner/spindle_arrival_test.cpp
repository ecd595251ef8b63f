#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <vector>

#include "motion_axes.hpp"
#include "planner/interpolator.hpp"

namespace kerf::planner {
namespace {

using base::TipPoint;
using motion::Line;
using motion::Motion;
using motion::Rapid;
using motion::Spindle;
using Actions = std::vector<Motion::Action>;

constexpr double kPeriod_s = 0.001;
const TipPoint kStart{{0, 0}};  // X as radius, Z

TipPoint place(double diameter, double z) { return {{diameter / 2, z}}; }

Spindle turning(double rpm, Spindle::Turning way = Spindle::Turning::clockwise) {
  return {.turning = way, .speed = rpm};
}

Spindle driven(Spindle::Turning way) {
  return {.turning = way, .speed = 600, .name = motion::SpindleName::live};
}

Line cut_to(double diameter, double z) {
  return {place(diameter, z), {0.2, motion::FeedMode::per_revolution}};
}

// Of a lathe whose spindles change their speed by so much.
double time_with(double rpm_per_s, const Actions& actions, const TipPoint& start = kStart) {
  motion::AxisSetup axes = test::axes_named("XZ", 20'000);
  axes.start = start;
  axes.spindle_acceleration.fill(rpm_per_s);
  Interpolator interpolator(axes,
                            test::equal_limits(350, 3500, std::numeric_limits<double>::infinity()),
                            {.period_s = kPeriod_s});
  test::pass_over(interpolator, test::motions_of(actions));
  return interpolator.time_s();
}

TEST(SpindleArrival, ACutWaitsForItsSpeed) {
  const Actions cut{turning(3000), cut_to(0, -10)};
  const double at_once = time_with(0, cut);
  EXPECT_NEAR(time_with(1500, cut), at_once + 2, 2 * kPeriod_s);
  EXPECT_NEAR(time_with(6000, cut), at_once + 0.5, 2 * kPeriod_s);
}

TEST(SpindleArrival, ItComesToSpeedWhileOtherThingsHappen) {
  const Actions behind_dwell{turning(3000), motion::Dwell{0.75}, cut_to(0, -10)};
  const double at_once = time_with(0, {turning(3000), cut_to(0, -10)});
  EXPECT_NEAR(time_with(3000, behind_dwell), at_once + 1, 2 * kPeriod_s);
  EXPECT_NEAR(time_with(6000, behind_dwell), at_once + 0.75, 2 * kPeriod_s);
}

TEST(SpindleArrival, AReversalTakesTwiceItsSpeed) {
  const Actions actions{turning(1000), cut_to(0, -1),
                        turning(1000, Spindle::Turning::counterclockwise), cut_to(0, -2)};
  EXPECT_NEAR(time_with(500, actions), time_with(0, actions) + 2 + 4, 3 * kPeriod_s);
}

TEST(SpindleArrival, ARapidAtSurfaceSpeedChangesTheSpeed) {
  const TipPoint start = place(100, 0);
  const auto rpm = [](double diameter) { return 1000 * 100 / (std::numbers::pi * diameter); };
  const Spindle surface{.turning = Spindle::Turning::clockwise,
                        .mode = Spindle::Mode::constant_surface_speed,
                        .speed = 100,
                        .max_rpm = 4000,
                        .radius_axis = base::Axis{0}};
  const Actions actions{surface, cut_to(100, -1), Rapid{place(40, -1)}, cut_to(40, -2)};
  const double rapid_s = time_with(0, {Rapid{place(40, 0)}}, start);
  const double waits_s = rpm(100) / 200 + (rpm(40) - rpm(100)) / 200 - rapid_s;
  EXPECT_NEAR(time_with(200, actions, start), time_with(0, actions, start) + waits_s, 0.01);
}

TEST(SpindleArrival, AFeedPerRevolutionFollowsTheDrivenTool) {
  const Spindle starts = driven(Spindle::Turning::clockwise);
  const Spindle stops = driven(Spindle::Turning::stopped);
  const double by_main = time_with(0, {turning(1200), cut_to(0, -10)});
  const double by_driven = time_with(0, {starts, cut_to(0, -10)});
  EXPECT_NEAR(by_driven, 2 * by_main, 0.01 * by_main);
  EXPECT_NEAR(time_with(0, {turning(1200), starts, cut_to(0, -10), stops, cut_to(0, 0)}),
              by_main + by_driven, 0.01);
}

}  // namespace
}  // namespace kerf::planner
