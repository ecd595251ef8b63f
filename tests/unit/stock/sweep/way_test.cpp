#include "stock/sweep/way.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace kerf::stock {
namespace {

using std::numbers::pi;

ArcWay helix() { return {{1, 2, 3}, {0, 0, -4}, {1, 0, 0}, {0, 1, 0}, 5, 1, pi / 4, -3 * pi}; }

void expect_near(Vec3 a, Vec3 b, double within) {
  EXPECT_LE(length(a - b), within)
      << a.x << ' ' << a.y << ' ' << a.z << " and " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(Way, OfAHelixBeginsAndEndsWhereItsEquationSays) {
  const double half = std::numbers::sqrt2 / 2;
  expect_near(point_at(helix(), 0), {1 + 5 * half, 2 + 5 * half, 3}, 1e-12);
  expect_near(point_at(helix(), 1), {1 - 6 * half, 2 - 6 * half, -1}, 1e-12);
}

TEST(Way, InPartsIsTheSameWay) {
  const ArcWay whole = helix();
  const ArcWay middle = part(whole, 0.25, 0.75);
  for (double t = 0; t <= 1; t += 0.125) {
    expect_near(point_at(middle, t), point_at(whole, 0.25 + 0.5 * t), 1e-12);
  }
}

TEST(Way, LiesWithinItsBounds) {
  const Bounds box = bounds(helix());
  for (double t = 0; t <= 1; t += 1.0 / 256) {
    const Vec3 at = point_at(helix(), t);
    EXPECT_GE(at.x, box.low.x);
    EXPECT_LE(at.x, box.high.x);
    EXPECT_GE(at.y, box.low.y);
    EXPECT_LE(at.y, box.high.y);
    EXPECT_GE(at.z, box.low.z);
    EXPECT_LE(at.z, box.high.z);
  }
}

TEST(Way, OfAQuarterCircleHasTheBoundsOfTheQuarter) {
  const Bounds box = bounds(ArcWay{{0, 0, 0}, {}, {1, 0, 0}, {0, 0, 1}, 2, 0, 0, pi / 2});
  expect_near(box.low, {0, 0, 0}, 1e-12);
  expect_near(box.high, {2, 0, 2}, 1e-12);
}

TEST(Way, HasTheLengthOfItsTip) {
  EXPECT_DOUBLE_EQ(length(StraightWay{{0, 0, 0}, {3, 4, 0}}), 5);
  EXPECT_NEAR(length(ArcWay{{0, 0, 0}, {0, 0, 3}, {1, 0, 0}, {0, 1, 0}, 2, 0, 0, 2}), 5, 1e-12);
}

}  // namespace
}  // namespace kerf::stock
