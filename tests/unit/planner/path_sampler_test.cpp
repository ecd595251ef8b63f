#include <gtest/gtest.h>

#include <cmath>

#include "allocation_count.hpp"
#include "planner/path_samples.hpp"

namespace kerf::planner {
namespace {

using namespace samples;
using motion::Arc;
using motion::Dwell;
using motion::FeedMode;
using motion::Line;

// What is neither line nor arc at feed.

TEST(PathSampler, RapidsGoAsFastAsTheSlowestAxisNeeds) {
  motion::AxisSetup axes = axes_named("XYA");
  axes.axes[0].rapid_per_min = 6000;   // 100 mm/s
  axes.axes[1].rapid_per_min = 12000;  // 200 mm/s
  axes.axes[2].rapid_per_min = 600;    // 10 degrees/s
  const struct {
    TipPoint to;
    double seconds;
  } rapids[] = {{{100}, 1}, {{{100, 300}}, 1.5}, {{{100, 300, 20}}, 2}};
  for (const Sampling sampling : {Sampling::tail, Sampling::equal}) {
    for (const auto& rapid : rapids) {
      PathSampler sampler(axes, settings_of(sampling));
      const Points points = test::points_of(sampler, test::motions_of({Rapid{rapid.to}}));
      EXPECT_EQ(points.size(), std::ceil(rapid.seconds / kPeriod_s - 1e-9));
      EXPECT_EQ(points.back().tip, rapid.to);
      EXPECT_EQ(points.back().mark.kind, motion::MoveKind::rapid);
    }
  }
}

// 90 degrees at 10 000 degrees/min are 0.54 s, whatever the feed.
TEST(PathSampler, RotaryAxesAloneTurnAtTheirRateInEqualSteps) {
  const TipPoint to{{0, 0, 0, 30, -90}};
  for (const Sampling sampling : {Sampling::tail, Sampling::equal}) {
    const Points points = sample({Line{to, {100}}}, settings_of(sampling));
    ASSERT_EQ(points.size(), 68U);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double share = static_cast<double>(i + 1) / 68;
      EXPECT_NEAR(points[i].tip.values[3], 30 * share, 1e-12);
      EXPECT_NEAR(points[i].tip.values[4], -90 * share, 1e-12);
    }
    EXPECT_EQ(points.back().tip, to);
  }
}

TEST(PathSampler, AMoveWhoseFeedCannotBeToldIsAsFastAsARapid) {
  const Points told = sample({Rapid{{100}}}, settings_of(Sampling::equal));
  const Points untold =
      sample({Line{{100}, {0.1, FeedMode::per_revolution}}}, settings_of(Sampling::equal));
  ASSERT_EQ(told.size(), untold.size());
  for (std::size_t i = 0; i < told.size(); ++i) EXPECT_EQ(told[i].tip, untold[i].tip);
}

TEST(PathSampler, FeedPerRevolutionIsThatOfTheSpindle) {
  using motion::Spindle;
  const Points points = sample({Spindle{Spindle::Turning::clockwise, Spindle::Mode::rpm, 600, 0},
                                Line{{10}, {0.5, FeedMode::per_revolution}}},
                               settings_of(Sampling::equal));
  EXPECT_EQ(points.size(), 250U) << "10 mm at 5 mm/s";
}

TEST(PathSampler, ADwellLastsWholePeriods) {
  const Points points =
      sample({Line{{1}, {7500}}, Dwell{0.03}, Line{{2}, {7500}}}, settings_of(Sampling::tail));
  ASSERT_EQ(points.size(), 6U);
  for (std::size_t i = 1; i <= 4; ++i) {
    EXPECT_EQ(points[i].tip, (AxisVector{{1}}));
    EXPECT_EQ(points[i].mark.kind, motion::MoveKind::dwell);
    EXPECT_EQ(points[i].mark.block.line, 2U);
  }
  EXPECT_EQ(points[5].tip, (AxisVector{{2}}));
}

TEST(PathSampler, EveryPeriodHasAPoint) {
  const Points points =
      sample({Rapid{{{7, 3}}}, Line{{{100, 50, 25, 30, 90}}, {3000}}, Dwell{0.1},
              Arc{.to = {{100, 70, 25, 30, 90}}, .center = {100, 60}, .feed = {3000}}},
             settings_of(Sampling::tail));
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(points[i].time_s, static_cast<double>(i + 1) * kPeriod_s);
}

TEST(PathSampler, AWayOfNoLengthHasNoPoints) {
  for (const Sampling sampling :
       {Sampling::tail, Sampling::equal, Sampling::equal_steps, Sampling::literal}) {
    EXPECT_TRUE(sample({Line{{}, {100}}, Rapid{}, Dwell{0}}, settings_of(sampling)).empty());
    EXPECT_EQ(sample({Line{{0.001}, {100}}}, settings_of(sampling)).size(), 1U);
  }
}

// Any number of motions.

std::vector<Motion> many_motions(int count) {
  std::vector<Motion::Action> actions;
  for (int i = 0; i < count; ++i) {
    const double x = i;
    actions.push_back(Rapid{{{x, 1}}});
    actions.push_back(Line{{{x + 10, 1}}, {60000}});
    actions.push_back(Arc{.to = {{x + 10, 3}}, .center = {x + 10, 2}, .feed = {30000}});
    actions.push_back(Dwell{0.01});
  }
  return test::motions_of(actions);
}

TEST(PathSampler, PassingOverThePointsKeepsTheTime) {
  const std::vector<Motion> motions = many_motions(2000);
  for (const Sampling sampling : {Sampling::tail, Sampling::equal_steps}) {
    PathSampler made(axes_named("XYZ"), settings_of(sampling));
    const Points points = test::points_of(made, motions);
    PathSampler passed(axes_named("XYZ"), settings_of(sampling));
    test::pass_over(passed, motions);
    EXPECT_EQ(passed.time_s(), made.time_s());
    EXPECT_EQ(points.back().time_s, made.time_s());
  }
}

TEST(PathSampler, AllocatesNothingOnTheWay) {
  const std::vector<Motion> motions = many_motions(2000);
  PathSampler sampler(axes_named("XYZ"), settings_of(Sampling::tail));
  motion::Setpoint point;
  std::uint64_t points = 0;
  const auto drive = [&](const Motion& motion) {
    sampler.take(motion);
    while (sampler.next(point)) ++points;
  };
  for (std::size_t i = 0; i < 4; ++i) drive(motions[i]);  // one of each kind
  const std::uint64_t before = test::allocations_so_far();
  for (const Motion& motion : motions) drive(motion);
  EXPECT_EQ(test::allocations_so_far(), before);
  EXPECT_GT(points, 10'000U);
}

}  // namespace
}  // namespace kerf::planner
