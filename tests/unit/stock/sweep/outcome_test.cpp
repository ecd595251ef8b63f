#include "stock/sweep/outcome.hpp"

#include <gtest/gtest.h>

namespace kerf::stock {
namespace {

TEST(Exact, AddsUpTheSameInEveryOrder) {
  Exact up;
  Exact down;
  for (int i = 1; i <= 1000; ++i) up += Exact(1e5 / i);
  for (int i = 1000; i >= 1; --i) down += Exact(1e5 / i);
  EXPECT_EQ(up, down);
  EXPECT_NEAR(up.value(), 748547.0860550345, 1e-6);
}

TEST(Exact, ClampsWhatIsOutOfRange) {
  EXPECT_DOUBLE_EQ(Exact(1e300).value(), 2147483647.0);
  EXPECT_DOUBLE_EQ(Exact(-1e300).value(), -2147483647.0);
}

TEST(Contact, KeepsTheDeepestPlaceWhateverTheOrder) {
  const Contact shallow{1, {0, 0, 0}, Exact(2)};
  const Contact deep{3, {5, 0, 0}, Exact(1)};
  const Contact as_deep{3, {4, 9, 0}, Exact(1)};
  Contact one;
  for (const Contact& next : {shallow, deep, as_deep}) one.add(next);
  Contact other;
  for (const Contact& next : {as_deep, deep, shallow}) other.add(next);
  for (const Contact& sum : {one, other}) {
    EXPECT_EQ(sum.at, as_deep.at);
    EXPECT_DOUBLE_EQ(sum.depth_mm, 3);
    EXPECT_DOUBLE_EQ(sum.volume.value(), 4);
  }
}

TEST(Contact, IsNoneUntilThereWasOne) {
  Contact none;
  none.add({});
  EXPECT_FALSE(none.is_one());
}

}  // namespace
}  // namespace kerf::stock
