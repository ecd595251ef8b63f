// What a part of the path allows where a linkage bends the tip's way: the inequality of
// docs/motion.md, "Through a linkage", written out.
#include "planner/cell_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "seeded_random.hpp"

namespace kerf::planner {
namespace {

constexpr double kPeriod_s = 0.008;
constexpr double kDelta_mm = 0.001;

// Axes that are never what limits the speed.
CellLimits limits() {
  AxisLimits axes;
  axes.velocity.values.fill(1e9);
  axes.acceleration.values.fill(1e-3);
  axes.jerk.values.fill(1e99);
  Settings settings;
  settings.period_s = kPeriod_s;
  settings.chord_tolerance_mm = kDelta_mm;
  return CellLimits(axes, settings, 1, {true});
}

double chord_mm(const CellBounds& bounds) {
  return limits().highest_speed(bounds, CellLimits::Use::path) * kPeriod_s;
}

TEST(CellLimits, ALinkageMayUseAllOfTheToleranceAndNoMore) {
  test::SeededRandom random(test::kSeed);
  for (int i = 0; i < 10'000; ++i) {
    CellBounds bounds;
    bounds.linkage.swing = random.size(1e-6, 1);
    bounds.linkage.bend = random.in(0, 1) * bounds.linkage.swing;
    bounds.linkage.gain = random.size(1e-6, 1) * 8 * kDelta_mm / std::pow(kPeriod_s, 4);
    const double gain_mm = bounds.linkage.gain * std::pow(kPeriod_s, 4);
    const double c = chord_mm(bounds);
    const bool steady = 11.0 / 48 * gain_mm <= 0.25 * 8 * kDelta_mm;
    const double used_mm = steady ? bounds.linkage.bend * c * c +
                                        std::sqrt(bounds.linkage.swing * gain_mm) * c / 6 +
                                        11.0 / 48 * gain_mm
                                  : bounds.linkage.swing * c * c;
    ASSERT_LE(used_mm, 8 * kDelta_mm * (1 + 1e-12));
    ASSERT_GE(used_mm, 8 * kDelta_mm * 0.95);
  }
}

TEST(CellLimits, AHeadThatDoesNotTurnIsHeldByTheCurvatureAlone) {
  CellBounds flat;
  flat.curvature = 0.1;
  CellBounds head = flat;
  head.linkage.gain = 1e-9;  // of axes that could turn
  for (const double seen : {0.0, 0.05, 0.15, 10.0}) {
    head.linkage.bend = seen;  // what the samples of a curve make of its second derivative
    EXPECT_NEAR(chord_mm(head), chord_mm(flat), 1e-9) << seen;
  }
}

TEST(CellLimits, WorkThatTurnsUnderItsOwnArcIsHeldByTheCurvature) {
  CellBounds bounds;
  bounds.curvature = 0.1;
  bounds.linkage = {.bend = 0, .swing = 0.12, .gain = 1e-9};
  CellBounds flat;
  flat.curvature = 0.1;
  EXPECT_NEAR(chord_mm(bounds), chord_mm(flat), 1e-6);
}

// What a feed is asked against without roots is what the highest speed says.
TEST(CellLimits, AFeedIsTakenWhereItIsBelowTheHighestSpeedAndCutOffThereElsewhere) {
  test::SeededRandom random(test::kSeed);
  AxisLimits axes;
  axes.velocity.values.fill(400);
  axes.acceleration.values.fill(3000);
  axes.jerk.values.fill(std::numeric_limits<double>::infinity());
  const CellLimits limits(axes, {}, 3, {true, true, true});
  for (int i = 0; i < 100'000; ++i) {
    CellBounds bounds;
    for (std::size_t m = 0; m < 3; ++m) {
      bounds.driven.first.values[m] = random.in(0, 1);
      bounds.driven.second.values[m] = random.coin() ? 0 : random.size(1e-4, 1e4);
    }
    bounds.curvature = random.coin() ? 0 : random.size(1e-4, 1e4);
    bounds.at_border = random.coin();
    const auto use = random.coin() ? CellLimits::Use::path : CellLimits::Use::corner;
    const double highest = limits.highest_speed(bounds, use);
    for (const double share : {0.1, 0.9, 1 - 1e-9, 1.0, 1 + 1e-9, 1.1, 10.0}) {
      const double feed = std::min(1e6, share * highest);
      ASSERT_EQ(limits.of(bounds, feed, use).velocity, std::min(feed, highest)) << i;
    }
  }
}

}  // namespace
}  // namespace kerf::planner
