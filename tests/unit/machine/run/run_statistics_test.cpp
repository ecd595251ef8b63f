#include "machine/run/run_statistics.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "motion_axes.hpp"

namespace kerf::machine {
namespace {

using base::TipPoint;
using motion::Arc;
using motion::Line;
using motion::Motion;
using motion::Rapid;
using motion::Spindle;
using motion::Thread;

TipPoint place(double diameter, double z) { return {{diameter / 2, z}}; }

Spindle surface(double metres_per_minute, double max_rpm) {
  return {.turning = Spindle::Turning::clockwise,
          .mode = Spindle::Mode::constant_surface_speed,
          .speed = metres_per_minute,
          .max_rpm = max_rpm,
          .radius_axis = base::Axis{0}};
}

motion::Feed per_turn(double mm) { return {mm, motion::FeedMode::per_revolution}; }

RunStatistics of(const motion::AxisSetup& axes, const std::vector<Motion::Action>& actions) {
  RunStatistics statistics(axes);
  for (const Motion& motion : test::motions_of(actions)) statistics.take(motion);
  return statistics;
}

double seconds_of(const TipPoint& start, const std::vector<Motion::Action>& actions) {
  motion::AxisSetup axes = test::axes_named("XZ", 20'000);
  axes.start = start;
  return of(axes, actions).feed_seconds();
}

TEST(RunStatistics, CountsSurfaceSpeedByItsIntegral) {
  struct Row {
    double from, from_z, to, to_z, clamp, s, feed, seconds;
  };
  for (const Row& row :
       {Row{50, 0, 0, 0, 3000, 200, 0.2, 3.4758}, Row{120, 0, 0, 0, 3000, 200, 0.05, 69.9805},
        Row{80, 0, -1.6, 0, 2500, 180, 0.15, 12.2148}, Row{20, 0, 60, -30, 4000, 150, 0.25, 7.2494},
        Row{40, 0, 100, -80, 4000, 150, 0.1, 75.1570},
        Row{75, 2, 75, -78, 3500, 140, 0.12, 67.3198}}) {
    const double seconds =
        seconds_of(place(row.from, row.from_z),
                   {surface(row.s, row.clamp), Line{place(row.to, row.to_z), per_turn(row.feed)}});
    EXPECT_NEAR(seconds, row.seconds, 5e-5);
  }
}

// A quarter of a circle about the spindle's axis: D = 2 R sin φ, so t = R 60 π / (1000 S F) 2 R.
TEST(RunStatistics, CountsAnArcAtSurfaceSpeed) {
  const Arc arc{.to = {{0, 10}},
                .center = {0, 0},
                .feed = per_turn(0.1),
                .plane = motion::Plane::zx,
                .direction = motion::Direction::clockwise};
  const double seconds = seconds_of({{10, 0}}, {surface(150, 0), arc});
  const double wanted = 10 * 60 * std::numbers::pi / (1000 * 150 * 0.1) * 2 * 10;
  EXPECT_NEAR(seconds, wanted, 1e-4 * wanted);
}

TEST(RunStatistics, CountsThreadsByTheirTurns) {
  Spindle spindle{.turning = Spindle::Turning::clockwise, .speed = 200};
  EXPECT_NEAR(seconds_of(place(30, 0), {spindle, Thread{place(30, -110), 1.5}}), 22, 1e-9);
  spindle.speed = 60;
  std::vector<Motion::Action> four{spindle};
  for (const double z : {-13, -26, -39, -52}) four.push_back(Thread{place(30, z), 2});
  EXPECT_NEAR(seconds_of(place(30, 0), four), 26, 1e-9);
  spindle.speed = 500;
  EXPECT_NEAR(seconds_of(place(10, 0), {spindle, Thread{place(50, -10), 1.5}}), 1.6, 1e-9);
}

TEST(RunStatistics, KeepsTheSpeedOfAThreadsBegin) {
  const double rpm = 100'000 / (std::numbers::pi * 30);
  EXPECT_NEAR(seconds_of(place(30, 0), {surface(100, 3000), Thread{place(30, -20), 1.5},
                                        Thread{place(50, -50), 1.5}}),
              50 / 1.5 * 60 / rpm, 1e-9);
}

TEST(RunStatistics, TellsWhereNoSpeedIsKnown) {
  const motion::AxisSetup axes = test::axes_named("XZ");
  EXPECT_EQ(of(axes, {Thread{{{0, -20}}, 2}}).untimed_line(), 1U);
  EXPECT_EQ(of(axes, {Rapid{{{3, 0}}}, Line{{{0, -20}}, per_turn(0.2)}}).untimed_line(), 2U);
}

}  // namespace
}  // namespace kerf::machine
