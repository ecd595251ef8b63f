#include "features/literal/literal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "feature_path.hpp"

namespace kerf::features {
namespace {

using motion::Direction;
using test::FeaturePath;

constexpr double kExact = 1e-6;

LiteralTree literally(const FeaturePath& path) {
  Allowance all;
  return recognise_literally(path.recording(), all);
}

void two_loops(FeaturePath& path, double z) {
  path.rapid(20, 20, 5).line(20, 20, z);
  path.line(40, 20, z).line(40, 28, z).line(20, 28, z).line(20, 20, z);
  path.line(15, 15, z).line(45, 15, z).line(45, 33, z).line(15, 33, z).line(15, 15, z);
  path.rapid(15, 15, 5);
}

TEST(Literal, EqualLayersOfTwoLoopsAreOnePocketInsideOut) {
  FeaturePath path;
  path.tool(1, 10);
  two_loops(path, -2);
  two_loops(path, -4);
  const LiteralTree tree = literally(path);
  ASSERT_EQ(tree.layers.size(), 2U);
  ASSERT_EQ(tree.layers[0].loops.size(), 2U);
  EXPECT_NEAR(tree.layers[0].loops[0].perimeter, 56, kExact);
  EXPECT_NEAR(tree.layers[0].loops[1].perimeter, 96, kExact);
  EXPECT_NEAR(tree.layers[1].loops[0].area, 160, kExact);
  EXPECT_NEAR(tree.layers[1].loops[1].area, 540, kExact);
  ASSERT_EQ(tree.features.size(), 1U);
  EXPECT_EQ(tree.features[0].layers.size(), 2U);
  EXPECT_EQ(tree.features[0].word.type, LiteralWord::Type::pocket);
  EXPECT_EQ(tree.features[0].word.kind, 1);
  EXPECT_EQ(tree.features[0].order, Order::inside_out);
}

TEST(Literal, ALoopWithARestInsideIsSideMilling) {
  FeaturePath path;
  path.tool(1, 10).rapid(80, 10, 5).line(80, 10, -6).line(110, 10, -6);
  path.arc(115, 15, -6, 110, 15, Direction::counterclockwise).line(115, 35, -6);
  path.arc(110, 40, -6, 110, 35, Direction::counterclockwise).line(80, 40, -6);
  path.arc(75, 35, -6, 80, 35, Direction::counterclockwise).line(75, 15, -6);
  path.arc(80, 10, -6, 80, 15, Direction::counterclockwise).rapid(80, 10, 5);
  const LiteralTree tree = literally(path);
  ASSERT_EQ(tree.features.size(), 1U);
  EXPECT_EQ(tree.features[0].word.type, LiteralWord::Type::side_milling);
  EXPECT_EQ(tree.features[0].order, Order::undefined);
  EXPECT_NEAR(tree.layers[0].loops[0].perimeter, 100 + 10 * std::numbers::pi, kExact);
  EXPECT_NEAR(tree.layers[0].loops[0].area, 1100 + 25 * std::numbers::pi, kExact);
}

TEST(Literal, ACircleSmallerThanTheToolIsARoundPocket) {
  FeaturePath path;
  path.tool(1, 10).rapid(65, 60, 5).line(65, 60, -3);
  path.arc(65, 60, -3, 62, 60, Direction::clockwise).rapid(65, 60, 5);
  const LiteralTree tree = literally(path);
  ASSERT_EQ(tree.features.size(), 1U);
  EXPECT_EQ(tree.features[0].word.kind, 2);
  EXPECT_NEAR(tree.layers[0].loops[0].area, -9 * std::numbers::pi, kExact);
}

TEST(Literal, ACircleOfChordsIsACircle) {
  FeaturePath path;
  path.tool(1, 10).rapid(3, 0, 5).line(3, 0, -3);
  for (int i = 1; i <= 24; ++i) {
    const double angle = i * std::numbers::pi / 12;
    path.line(i == 24 ? 3 : 3 * std::cos(angle), i == 24 ? 0 : 3 * std::sin(angle), -3);
  }
  path.rapid(3, 0, 5);
  const LiteralTree tree = literally(path);
  ASSERT_EQ(tree.features.size(), 1U);
  EXPECT_EQ(tree.features[0].word.kind, 2);
}

TEST(Literal, PecksAtOnePlaceAreOneHole) {
  FeaturePath path;
  path.tool(2, 6).rapid(10, 50, 5).line(10, 50, -4).rapid(10, 50, 1).rapid(10, 50, -3);
  path.line(10, 50, -8).rapid(10, 50, 5).rapid(30, 50, 5).line(30, 50, -8).rapid(30, 50, 5);
  const LiteralTree tree = literally(path);
  ASSERT_EQ(tree.holes.size(), 2U);
  EXPECT_EQ(tree.holes[0].z, -8);
  EXPECT_EQ(tree.holes[1].at, (Vec2{30, 50}));
  EXPECT_TRUE(tree.layers.empty());
}

TEST(Literal, AStraightPassIsNeitherHoleNorFeature) {
  FeaturePath path;
  path.tool(1, 10).rapid(10, 20, 5).line(10, 20, -3).line(50, 20, -3).rapid(50, 20, 5);
  const LiteralTree tree = literally(path);
  EXPECT_TRUE(tree.holes.empty());
  EXPECT_TRUE(tree.features.empty());
  ASSERT_EQ(tree.layers.size(), 1U);
  EXPECT_TRUE(tree.layers[0].loops.empty());
}

}  // namespace
}  // namespace kerf::features
