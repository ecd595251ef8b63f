#include "planner/internal/motion_ends.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion_axes.hpp"
#include "planner/interpolator.hpp"
#include "planner/path_sampler.hpp"
#include "seeded_random.hpp"

namespace kerf::planner {
namespace {

using motion::Dwell;
using motion::Line;
using motion::Motion;
using motion::Rapid;
using test::axes_named;

struct Ends final : motion::MotionEndSink {
  struct End {
    std::uint64_t motion;
    double time_s;
  };
  void motion_ends(std::uint64_t motion, double time_s) override {
    ends.push_back({motion, time_s});
  }
  std::vector<End> ends;
};

Settings settings_of(double tolerance_mm) {
  Settings settings;
  settings.tolerance_mm = tolerance_mm;
  return settings;
}

std::vector<Ends::End> ends_of(const std::vector<Motion>& motions, double tolerance_mm,
                               bool by_points) {
  const auto axes = axes_named("XYZ");
  const AxisLimits limits = test::equal_limits(200, 1000, 20000);
  Interpolator source(axes, limits, settings_of(tolerance_mm));
  Ends ends;
  source.tell_ends(ends);
  if (by_points) {
    static_cast<void>(test::points_of(source, motions));
  } else {
    test::pass_over(source, motions);
  }
  return ends.ends;
}

std::vector<Motion> random_path(unsigned seed, int count) {
  test::SeededRandom random(seed);
  std::vector<Motion::Action> actions;
  for (int i = 0; i < count; ++i) {
    base::TipPoint to;
    for (std::size_t m = 0; m < 3; ++m) to.values[m] = random.in(-20, 20);
    if (random.in(0, 1) < 0.2) {
      actions.push_back(Rapid{to});
    } else {
      actions.push_back(Line{to, {random.in(100, 5000)}});
    }
    if (random.in(0, 1) < 0.1) actions.push_back(Dwell{random.in(0.01, 0.3)});
  }
  return test::motions_of(actions);
}

TEST(MotionEnds, ALineEndsAfterItsRampsAndItsWay) {
  base::TipPoint to;
  to.values[0] = 50;
  const auto ends = ends_of(test::motions_of({Line{to, {1200}}, Dwell{0.25}}), 0.01, false);
  ASSERT_EQ(ends.size(), 2U);
  // From rest to rest with limited jerk: v = 20 ≤ a²/j = 50, so each ramp lasts 2 √(v/j).
  const double rise = std::sqrt(20.0 / 20000);
  EXPECT_NEAR(ends[0].time_s, 50.0 / 20 + 2 * rise, 1e-9);
  EXPECT_EQ(ends[0].motion, 1U);
  EXPECT_NEAR(ends[1].time_s - ends[0].time_s, 0.25, 0.0011);  // dwells begin at a period
}

TEST(MotionEnds, AreTheSameWhetherPointsAreMadeOrPassedOver) {
  const auto motions = random_path(7, 300);
  const auto by_points = ends_of(motions, 0.02, true);
  const auto passed = ends_of(motions, 0.02, false);
  ASSERT_EQ(by_points.size(), motions.size());
  ASSERT_EQ(passed.size(), motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    EXPECT_EQ(by_points[i].motion, i + 1);
    EXPECT_NEAR(by_points[i].time_s, passed[i].time_s, 1e-9);
  }
}

// The set-points are the second method: a motion is over no later than the first point of the next
// one, and not before its own last point but one.
TEST(MotionEnds, LieBetweenTheSetPointsOfTwoMotions) {
  for (const double tolerance : {0.0, 0.05}) {
    const auto motions = random_path(11, 400);
    const auto axes = axes_named("XYZ");
    const AxisLimits limits = test::equal_limits(200, 1000, 20000);
    Interpolator source(axes, limits, settings_of(tolerance));
    Ends ends;
    source.tell_ends(ends);
    const auto points = test::points_of(source, motions);
    std::vector<double> last(motions.size() + 2, -1);
    std::vector<double> first(motions.size() + 2, 1e9);
    for (const motion::Setpoint& point : points) {
      last[point.mark.motion] = point.time_s;
      first[point.mark.motion] = std::min(first[point.mark.motion], point.time_s);
    }
    double next_first = 1e9;
    for (std::size_t i = ends.ends.size(); i-- > 0;) {
      const auto [motion, time_s] = ends.ends[i];
      EXPECT_LE(time_s, next_first + 1e-9) << motion;
      EXPECT_GE(time_s, last[motion] - settings_of(0).period_s - 1e-9) << motion;
      next_first = std::min(next_first, first[motion]);
    }
    EXPECT_EQ(ends.ends.size(), motions.size());
  }
}

TEST(MotionEnds, OfASamplerAreThoseOfItsLastPoints) {
  Settings settings;
  settings.sampling = Sampling::equal;
  PathSampler source(axes_named("XYZ"), settings);
  Ends ends;
  source.tell_ends(ends);
  base::TipPoint to;
  to.values[0] = 10;
  test::pass_over(source, test::motions_of({Line{to, {600}}, Dwell{1}}));
  ASSERT_EQ(ends.ends.size(), 2U);
  EXPECT_NEAR(ends.ends[0].time_s, 1, 1e-9);
  EXPECT_NEAR(ends.ends[1].time_s, 2, 1e-9);
}

}  // namespace
}  // namespace kerf::planner
