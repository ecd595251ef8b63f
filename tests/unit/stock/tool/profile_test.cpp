#include "stock/tool/profile.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace kerf::stock {
namespace {

const double kQuarter = std::sqrt(2.0) - 1;

Profile ball(double radius, double flutes) {
  return Profile({{{0, 0}, {radius, radius}, kQuarter, ToolPart::edge},
                  {{radius, radius}, {radius, flutes}, 0, ToolPart::edge},
                  {{radius, flutes}, {radius, 2 * flutes}, 0, ToolPart::flank},
                  {{radius, 2 * flutes}, {20, 2 * flutes}, 0, ToolPart::holder},
                  {{20, 2 * flutes}, {20, 100}, 0, ToolPart::holder}});
}

TEST(Profile, HasTheRadiusOfABallUpToItsEquator) {
  const Profile tool = ball(3, 12);
  EXPECT_NEAR(tool.radius_at(0), 0, 1e-12);
  EXPECT_NEAR(tool.radius_at(1), std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(tool.radius_at(3), 3, 1e-12);
  EXPECT_NEAR(tool.radius_at(12), 3, 1e-12);
}

TEST(Profile, HasTheLargerRadiusWhereAShoulderLies) {
  EXPECT_DOUBLE_EQ(ball(3, 12).radius_at(24), 20);
}

TEST(Profile, TellsWhereItsPartsEnd) {
  const Profile tool = ball(3, 12);
  EXPECT_DOUBLE_EQ(tool.edge_height(), 12);
  EXPECT_DOUBLE_EQ(tool.height(), 100);
  EXPECT_DOUBLE_EQ(tool.widest(ToolPart::edge), 3);
  EXPECT_DOUBLE_EQ(tool.widest(ToolPart::shank), 0);
  EXPECT_DOUBLE_EQ(tool.widest(), 20);
}

TEST(Profile, HasAnUndercutWhereItsEdgesComeBackInwards) {
  EXPECT_FALSE(ball(3, 12).has_undercut());
  const Profile slot({{{0, 0}, {8, 0}, 0, ToolPart::edge},
                      {{8, 0}, {8, 4}, 0, ToolPart::edge},
                      {{8, 4}, {3.5, 4}, 0, ToolPart::edge},
                      {{3.5, 4}, {3.5, 30}, 0, ToolPart::shank}});
  EXPECT_TRUE(slot.has_undercut());
}

TEST(Profile, OfAConcaveArcIsNearerToTheAxisThanItsChord) {
  const Profile form({{{0, 0}, {5, 5}, -kQuarter, ToolPart::edge}});
  EXPECT_NEAR(form.radius_at(3), 5 - 4, 1e-12);  // about (5, 0)
}

}  // namespace
}  // namespace kerf::stock
