// The angles of a beam that stands along a normal, and the turn that is nearest.
#include "kinematics/orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/angle.hpp"
#include "seeded_random.hpp"

namespace kerf::kinematics {
namespace {

using test::kSeed;
using test::SeededRandom;

constexpr int kCases = 100'000;

TEST(Orientation, BeamStandsAlongTheNormalInBothPositions) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const geometry::Vec3 normal{random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)};
    const HeadAngles previous{random.in(-180, 180), random.in(-1000, 1000)};
    const auto both = orientations(normal, previous);
    ASSERT_TRUE(both);
    for (const HeadAngles& angles : *both) {
      ASSERT_LE(length(beam_axis(angles) - unit(normal)), 1e-12);
      ASSERT_LE(std::fabs(angles.c_deg - previous.c_deg), 180 + 1e-9);
    }
    ASSERT_NEAR(both->at(0).a_deg, -both->at(1).a_deg, 1e-12);
  }
}

TEST(NearestTurn, LiesWithinHalfATurn) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const double angle = random.in(-2000, 2000);
    const double previous = random.in(-2000, 2000);
    const double turn = random.coin() ? 360 : 180;
    const double nearest = geometry::nearest_turn(angle, previous, turn);
    ASSERT_LE(std::fabs(nearest - previous), turn / 2 + 1e-9);
    ASSERT_NEAR(std::remainder(nearest - angle, turn), 0, 1e-9);
  }
  EXPECT_EQ(geometry::nearest_turn(180, 0), -180) << "as far either way";
}

}  // namespace
}  // namespace kerf::kinematics
