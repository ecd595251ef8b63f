#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "geometry/angle.hpp"
#include "seeded_random.hpp"

namespace kerf::geometry {
namespace {

using test::kSeed;
using test::SeededRandom;

std::string six_decimals(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6f", value);
  return text;
}

struct Row {
  Vec2 way;
  const char* printed;
};

constexpr Row kTable[] = {
    {{1, 0}, "0.000000"},         {{1, 1}, "45.000000"},     {{0, 2}, "90.000000"},
    {{-3, 4}, "126.869898"},      {{-1, 0}, "180.000000"},   {{-5, -12}, "247.380135"},
    {{0, -1}, "270.000000"},      {{1, -1}, "315.000000"},   {{3, 4}, "53.130102"},
    {{10, -0.001}, "359.994270"}, {{1, -1e-12}, "0.000000"}, {{0, 0}, "360.000000"}};

TEST(Heading, IsCountedCounterclockwiseFromTheFirstAxis) {
  for (const Row& row : kTable) {
    EXPECT_EQ(six_decimals(heading_deg({0, 0}, row.way)), row.printed)
        << row.way.u << ", " << row.way.v;
  }
}

TEST(Heading, IsExactAlongTheAxes) {
  EXPECT_EQ(heading_deg({3, 4}, {9, 4}), 0);
  EXPECT_EQ(heading_deg({3, 4}, {3, 9}), 90);
  EXPECT_EQ(heading_deg({3, 4}, {-9, 4}), 180);
  EXPECT_EQ(heading_deg({3, 4}, {3, -9}), 270);
}

TEST(Heading, PointsThatAreOneHaveNone) {
  EXPECT_EQ(heading_deg({5, 5}, {5, 5}), kNoHeading_deg);
  EXPECT_EQ(heading_deg({0, 0}, {0.9e-6, 0}), kNoHeading_deg);
  EXPECT_EQ(heading_deg({0, 0}, {0, -1.1e-6}), 270);
}

TEST(Heading, OfADirectionIsNeverPrintedAsAFullTurn) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 100'000; ++i) {
    const double rise = random.size(1e-14, 1) * (random.coin() ? 1 : -1);
    const double heading = heading_deg({0, 0}, {1, rise});
    ASSERT_GE(heading, 0) << rise;
    ASSERT_NE(six_decimals(heading), "360.000000") << rise;
  }
}

TEST(Heading, LeadsFromOnePointToTheOther) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 100'000; ++i) {
    const Vec2 from{random.in(-100, 100), random.in(-100, 100)};
    const Vec2 to{random.in(-100, 100), random.in(-100, 100)};
    const SineCosine turn = sine_cosine_deg(heading_deg(from, to));
    const double reach = length(to - from);
    ASSERT_NEAR(from.u + reach * turn.cosine, to.u, 2e-8 * (1 + reach));
    ASSERT_NEAR(from.v + reach * turn.sine, to.v, 2e-8 * (1 + reach));
  }
}

}  // namespace
}  // namespace kerf::geometry
