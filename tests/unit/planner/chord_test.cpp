#include "planner/chord.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "seeded_random.hpp"

namespace kerf::planner {
namespace {

using test::kSeed;
using test::SeededRandom;

constexpr double kDeviation_mm = 0.001;
constexpr double kPeriod_s = 0.008;
constexpr double kSecondsPerMinute = 60;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct FeedRow {
  double radius_mm;
  double chord_feed_mm_min;
  double step_feed_mm_min;
  double chord_mm;
};

// 0.001 mm within 8 ms, with four and six decimals.
constexpr FeedRow kFeeds[] = {
    {0.25, 335.0746, 335.5221, 0.044677},     {0.5, 474.1044, 474.4207, 0.063214},
    {1, 670.6527, 670.8763, 0.089420},        {2, 948.5647, 948.7228, 0.126475},
    {5, 1499.9250, 1500.0250, 0.199990},      {10, 2121.2673, 2121.3380, 0.282836},
    {50, 4743.3928, 4743.4244, 0.632452},     {100, 6708.1872, 6708.2095, 0.894425},
    {500, 14999.9925, 15000.0025, 1.999999},  {1000, 21213.1981, 21213.2052, 2.828426},
    {5000, 47434.1625, 47434.1657, 6.324555},
};

TEST(Chord, FeedsOfThePublishedTable) {
  for (const FeedRow& row : kFeeds) {
    const double chord_feed = chord_feed_mm_s(row.radius_mm, kDeviation_mm, kPeriod_s);
    const double step_feed = step_feed_mm_s(row.radius_mm, kDeviation_mm, kPeriod_s);
    EXPECT_NEAR(chord_feed * kSecondsPerMinute, row.chord_feed_mm_min, 5e-5) << row.radius_mm;
    EXPECT_NEAR(step_feed * kSecondsPerMinute, row.step_feed_mm_min, 5e-5) << row.radius_mm;
    EXPECT_NEAR(longest_chord_mm(row.radius_mm, kDeviation_mm), row.chord_mm, 5e-7);
    EXPECT_NEAR(chord_feed * kPeriod_s, row.chord_mm, 5e-7) << row.radius_mm;
  }
}

// √(225000 (2R - 1)), as printed, and what it forbids.
TEST(Chord, TheFormWithMixedUnitsIsSafe) {
  for (const FeedRow& row : kFeeds) {
    const double square = 225000 * (2 * row.radius_mm - 1);
    EXPECT_LT(std::sqrt(std::max(0.0, square)), row.chord_feed_mm_min) << row.radius_mm;
  }
  const double right = kSecondsPerMinute * chord_feed_mm_s(1, kDeviation_mm, kPeriod_s);
  EXPECT_NEAR(std::sqrt(225000 * (2 * 1 - 1)) / right, 1 - 0.293, 5e-4);
}

struct DeviationRow {
  double radius_mm;
  double length_mm;
  double of_chord_mm;
  double of_step_mm;
};

constexpr DeviationRow kDeviations[] = {
    {10, 0.4, 0.002000200, 0.001999933},  {10, 0.282835678, 0.001000000, 0.000999934},
    {5, 0.5, 0.006253911, 0.006248698},   {100, 1, 0.001250008, 0.001249997},
    {0.5, 0.2, 0.010102051, 0.009966711}, {1000, 2, 0.000500000, 0.000500000},
};

TEST(Chord, DeviationsOfThePublishedTable) {
  for (const DeviationRow& row : kDeviations) {
    EXPECT_NEAR(chord_deviation_mm(row.radius_mm, row.length_mm), row.of_chord_mm, 5e-10);
    EXPECT_NEAR(step_deviation_mm(row.radius_mm, row.length_mm), row.of_step_mm, 5e-10);
  }
}

TEST(Chord, NoLimitWhereTheRadiusIsNoLargerThanTheDeviation) {
  for (const double radius : {0.001, 0.0005, 1e-9}) {
    EXPECT_EQ(longest_chord_mm(radius, kDeviation_mm), kInfinity);
    EXPECT_EQ(longest_step_mm(radius, kDeviation_mm), kInfinity);
    EXPECT_EQ(chord_feed_mm_s(radius, kDeviation_mm, kPeriod_s), kInfinity);
    EXPECT_EQ(step_feed_mm_s(radius, kDeviation_mm, kPeriod_s), kInfinity);
  }
}

TEST(Chord, TheLongestOnesDeviateByExactlyTheDeviation) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 100'000; ++i) {
    const double deviation = random.size(1e-6, 1);
    const double radius = deviation * (1 + random.size(1e-6, 1e9));
    const double chord = longest_chord_mm(radius, deviation);
    const double step = longest_step_mm(radius, deviation);
    ASSERT_NEAR(chord_deviation_mm(radius, chord), deviation, 1e-6 * deviation) << radius;
    ASSERT_NEAR(step_deviation_mm(radius, step), deviation, 1e-12 * deviation) << radius;
    ASSERT_GE(step, chord) << radius << " " << deviation;
  }
}

// The middle of the arc lies farthest from the chord; both computed with more digits.
TEST(Chord, DeviationIsTheDistanceOfTheMiddleFromTheChord) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 100'000; ++i) {
    const long double radius = random.size(0.01, 1e6);
    const long double angle = random.size(1e-5, 3);
    const long double apart = radius - radius * std::cos(angle / 2);
    const auto r = static_cast<double>(radius);
    const auto step = static_cast<double>(radius * angle);
    const auto chord = static_cast<double>(2 * radius * std::sin(angle / 2));
    const auto wanted = static_cast<double>(apart);
    ASSERT_NEAR(step_deviation_mm(r, step), wanted, 1e-7 * wanted) << r << " " << step;
    ASSERT_NEAR(chord_deviation_mm(r, chord), wanted, 1e-7 * wanted) << r << " " << chord;
  }
}

}  // namespace
}  // namespace kerf::planner
