#include "stock/cutting/engagement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "geometry/angle.hpp"

namespace kerf::stock {
namespace {

using geometry::degrees;

constexpr double kRadius_mm = 5;

/// What rows of columns of this size along the feed leave, as far as `takes` says, over a length.
Outcome rows(double cell_mm, double length_mm, double depth_mm,
             const std::function<bool(double s)>& takes) {
  Outcome outcome;
  for (int i = 0; i < static_cast<int>(std::lround(2 * kRadius_mm / cell_mm)); ++i) {
    const double s = -kRadius_mm + (i + 0.5) * cell_mm;
    if (!takes(s)) continue;
    const Exact volume(cell_mm * length_mm * depth_mm);
    const double bin = (s + kRadius_mm) / (2 * kRadius_mm) * Outcome::kBins;
    outcome.across[static_cast<std::size_t>(bin)] += volume;
    outcome.removed += volume;
    outcome.aside.add(s);
  }
  outcome.heights.add(-depth_mm);
  outcome.heights.add(0);
  return outcome;
}

Engagement engaged(const Outcome& outcome, double length_mm, double cell_mm) {
  return engagement_of(outcome,
                       {.radius_mm = kRadius_mm, .length_mm = length_mm, .grain_mm = cell_mm});
}

/// The angle of a circle between two distances from the way of its middle, by adding up chords of
/// the circle: a second method.
double angle_between(double from, double to) {
  constexpr int kSteps = 2'000'000;
  double length = 0;
  double before = -std::numbers::pi / 2;
  for (int i = 1; i <= kSteps; ++i) {
    const double angle = std::numbers::pi * (static_cast<double>(i) / kSteps - 0.5);
    const double s = kRadius_mm * std::sin(angle);
    if (s > from && s <= to) length += angle - before;
    before = angle;
  }
  return length;
}

TEST(Engagement, OfASlotIsHalfATurn) {
  for (const double cell : {0.05, 0.1, 0.25, 0.5}) {
    const Engagement all = engaged(rows(cell, 50, 5, [](double) { return true; }), 50, cell);
    EXPECT_NEAR(all.ae_mm, 10, 1e-9) << cell;
    EXPECT_NEAR(all.ap_mm, 5, 1e-9) << cell;
    EXPECT_NEAR(degrees(all.phi_rad), 180, 1e-9) << cell;
    EXPECT_EQ(all.side, CuttingSide::slot) << cell;
  }
}

TEST(Engagement, AtTheSideIsTheArcusCosineOfItsWidth) {
  for (const double cell : {0.05, 0.1, 0.25, 0.5}) {
    for (const double ae : {1.0, 2.0, 4.0, 7.5}) {
      const Outcome right = rows(cell, 30, 3, [&](double s) { return s < ae - kRadius_mm; });
      const Engagement side = engaged(right, 30, cell);
      EXPECT_NEAR(side.ae_mm, ae, 1e-9) << cell;
      EXPECT_NEAR(side.ap_mm, 3, 1e-9) << cell;
      EXPECT_NEAR(side.phi_rad, std::acos(1 - 2 * ae / 10), 1e-9) << cell;
      EXPECT_NEAR(side.phi_rad, angle_between(-kRadius_mm, ae - kRadius_mm), 1e-5) << cell;
      EXPECT_EQ(side.side, CuttingSide::climb);
    }
  }
  const Outcome two = rows(0.1, 30, 3, [](double s) { return s > 3; });
  EXPECT_NEAR(degrees(engaged(two, 30, 0.1).phi_rad), 53.1301024, 1e-6);
}

TEST(Engagement, ClimbsWithTheMaterialOnItsRightUnderM03) {
  const Outcome right = rows(0.1, 30, 3, [](double s) { return s < -2; });
  const Outcome left = rows(0.1, 30, 3, [](double s) { return s > 2; });
  EngagementSetting setting{.radius_mm = kRadius_mm, .length_mm = 30, .grain_mm = 0.1};
  EXPECT_EQ(engagement_of(right, setting).side, CuttingSide::climb);
  EXPECT_EQ(engagement_of(left, setting).side, CuttingSide::conventional);
  setting.turns_left = true;
  EXPECT_EQ(engagement_of(right, setting).side, CuttingSide::conventional);
  EXPECT_EQ(engagement_of(left, setting).side, CuttingSide::climb);
}

TEST(Engagement, LeavesOutWhatStandsFreeBetweenTwoWalls) {
  const Outcome walls = rows(0.1, 20, 2, [](double s) { return std::fabs(s) > 3; });
  const Engagement both = engaged(walls, 20, 0.1);
  const double bin = 10.0 / Outcome::kBins;
  EXPECT_NEAR(both.ae_mm, 4, bin);
  EXPECT_NEAR(both.phi_rad, 2 * angle_between(3, kRadius_mm), 0.06);
  EXPECT_EQ(both.side, CuttingSide::slot);
}

TEST(Engagement, IsNoDeeperThanWhatWasRemoved) {
  // A short move that a whole row of columns falls to: by its volume alone it would be 12.5 deep.
  Outcome outcome = rows(0.25, 0.25, 5, [](double) { return true; });
  const Engagement moved = engaged(outcome, 0.1, 0.25);
  EXPECT_NEAR(moved.ap_mm, 5, 1e-9);
}

TEST(Engagement, OfNothingIsNothing) {
  const Engagement none = engaged(Outcome{}, 10, 0.1);
  EXPECT_EQ(none.ae_mm, 0);
  EXPECT_EQ(none.phi_rad, 0);
  EXPECT_EQ(none.side, CuttingSide::none);
}

}  // namespace
}  // namespace kerf::stock
