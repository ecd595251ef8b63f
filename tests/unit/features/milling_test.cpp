#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "features/recognition.hpp"
#include "small_cam.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Region;
using motion::Direction;
using stock::ToolKind;
using test::FeaturePath;

constexpr double kExact = 1e-6;
constexpr double kPi = std::numbers::pi;

Blank block(double x0, double y0, double x1, double y1, double bottom) {
  return {.is_known = true,
          .outline = {{{{{{x0, y0}}, {{x1, y0}}, {{x1, y1}}, {{x0, y1}}}, true}}},
          .top = 0,
          .bottom = bottom};
}

/// A mill with T1 in its spindle, which turns.
struct FlatPath : FeaturePath {
  explicit FlatPath(double diameter) { tool(1, diameter).spindle(3000); }
};

void two_loops(FeaturePath& path, double z) {
  path.rapid(20, 20, 5).line(20, 20, z);
  path.line(40, 20, z).line(40, 28, z).line(20, 28, z).line(20, 20, z);
  path.line(15, 15, z).line(45, 15, z).line(45, 33, z).line(15, 33, z).line(15, 15, z);
  path.rapid(15, 15, 5);
}

TEST(Milling, EqualLevelsOfTwoLoopsAreOnePocket) {
  FlatPath path(10);
  two_loops(path, -2);
  two_loops(path, -4);
  const Tree tree = recognise(path.recording(), {}, Method::both);
  ASSERT_EQ(tree.features.size(), 1U);
  const Feature& pocket = tree.features[0];
  EXPECT_EQ(pocket.type, FeatureType::pocket);
  ASSERT_EQ(pocket.layers.size(), 2U);
  for (const Layer& layer : pocket.layers) EXPECT_NEAR(layer.area, 1120 - (4 - kPi) * 25, kExact);
  EXPECT_NEAR(pocket.volume(), 4394.159265, kExact);
  EXPECT_EQ(pocket.order, Order::inside_out);
  EXPECT_EQ(pocket.strategy, Strategy::contour_parallel);
  EXPECT_EQ(pocket.milling, Milling::climb);
  EXPECT_NEAR(pocket.stepover.value_or(0), 5, kExact);
  EXPECT_NEAR(pocket.stepdown.value_or(0), 2, kExact);
  EXPECT_EQ(pocket.entry.kind, Entry::Kind::plunge);
  EXPECT_EQ(pocket.key, "5b3956dc");
  EXPECT_TRUE(pocket.agree);
  EXPECT_NEAR(pocket.confidence, 0.6, kExact);
}

// The corners of a contour are as round as the tool; a drawing would not have them so.
TEST(Milling, RoundCornersOfTheToolAreSharpInTheNominalContour) {
  FlatPath path(10);
  two_loops(path, -2);
  const Tree tree = recognise(path.recording(), {}, Method::swept);
  const Layer& layer = tree.features.at(0).layers.at(0);
  EXPECT_EQ(layer.contour.vertices.size(), 8U);
  ASSERT_EQ(layer.nominal.vertices.size(), 4U);
  EXPECT_NEAR(contour::area(layer.nominal), 40 * 28, kExact);
}

TEST(Milling, ARingRoundAPieceIsAnOutsideProfile) {
  FlatPath path(10);
  path.rapid(80, 10, 5).line(80, 10, -6).line(110, 10, -6);
  path.arc(115, 15, -6, 110, 15, Direction::counterclockwise).line(115, 35, -6);
  path.arc(110, 40, -6, 110, 35, Direction::counterclockwise).line(80, 40, -6);
  path.arc(75, 35, -6, 80, 35, Direction::counterclockwise).line(75, 15, -6);
  path.arc(80, 10, -6, 80, 15, Direction::counterclockwise).rapid(80, 10, 5);
  const Tree tree = recognise(path.recording(), {}, Method::both);
  ASSERT_EQ(tree.features.size(), 1U);
  const Feature& profile = tree.features[0];
  EXPECT_EQ(profile.type, FeatureType::outside_profile);
  EXPECT_NEAR(profile.volume(), 1314.159265 * 6, 1e-5);
  EXPECT_NEAR(contour::area(profile.layers[0].nominal), 30 * 20, kExact);
  EXPECT_EQ(profile.milling, Milling::conventional);
}

TEST(Milling, ACircleSmallerThanTheToolIsARoundPocket) {
  FlatPath path(10);
  path.rapid(65, 60, 5).line(65, 60, -3);
  path.arc(65, 60, -3, 62, 60, Direction::clockwise).rapid(65, 60, 5);
  const Tree tree = recognise(path.recording(), {}, Method::both);
  ASSERT_EQ(tree.features.size(), 1U);
  ASSERT_TRUE(tree.features[0].measures.round);
  EXPECT_NEAR(tree.features[0].measures.round->diameter, 16, kExact);
  EXPECT_NEAR(tree.features[0].volume(), 192 * kPi, kExact);
}

TEST(Milling, WhereTheWallEndsAtTheBlankAPocketIsOpen) {
  FlatPath path(10);
  path.rapid(68, 15, 5).line(68, 15, -4).line(25, 15, -4).line(25, 23, -4).line(68, 23, -4);
  path.rapid(68, 23, 5);
  const Tree tree = recognise(path.recording(), block(0, 0, 60, 40, -20), Method::swept);
  ASSERT_EQ(tree.features.size(), 1U);
  EXPECT_EQ(tree.features[0].type, FeatureType::open_pocket);
  EXPECT_EQ(tree.features[0].entry.kind, Entry::Kind::outside);
  EXPECT_NEAR(tree.features[0].layers[0].area, 40 * 18 - (4 - kPi) * 25 / 2, kExact);
}

TEST(Milling, AlongOneSideOfTheBlankItIsAStep) {
  FlatPath path(10);
  path.rapid(-8, 0, 5).line(-8, 0, -4).line(68, 0, -4).rapid(68, 7, -4).line(-8, 7, -4);
  path.rapid(-8, 7, 5);
  const Tree tree = recognise(path.recording(), block(0, 0, 60, 40, -20), Method::swept);
  ASSERT_EQ(tree.features.size(), 1U);
  EXPECT_EQ(tree.features[0].type, FeatureType::step);
  EXPECT_NEAR(tree.features[0].measures.wall_share.value_or(0), 60.0 / 144, kExact);
}

TEST(Milling, AStraightPassIsASlotWithItsOpenEnds) {
  for (const auto& [from, ends] : {std::pair(-8.0, 1), std::pair(12.0, 0)}) {
    FlatPath path(10);
    path.rapid(from, 20, 5).line(from, 20, -3).line(40, 20, -3).rapid(40, 20, 5);
    const Tree tree = recognise(path.recording(), block(0, 0, 60, 40, -20), Method::swept);
    ASSERT_EQ(tree.features.size(), 1U);
    EXPECT_EQ(tree.features[0].type, FeatureType::slot);
    EXPECT_EQ(tree.features[0].measures.open_ends.value_or(9), ends);
    EXPECT_NEAR(tree.features[0].measures.width.value_or(0), 10, kExact);
  }
}

TEST(Milling, APocketInTheFloorOfAnotherHangsOnIt) {
  FlatPath path(10);
  two_loops(path, -2);
  path.rapid(24, 20, 5).line(24, 20, -6).line(36, 20, -6).line(36, 28, -6).line(24, 28, -6);
  path.line(24, 20, -6).rapid(24, 20, 5);
  const Tree tree = recognise(path.recording(), {}, Method::swept);
  ASSERT_EQ(tree.features.size(), 2U);
  EXPECT_NEAR(tree.features[1].top, -2, kExact);
  ASSERT_TRUE(tree.features[1].parent);
  EXPECT_EQ(tree.features[1].parent->feature, 0U);
  EXPECT_EQ(tree.features[1].parent->kind, RelationKind::nested);
}

TEST(Milling, AFaceCoversTheWholeBlank) {
  FeaturePath path;
  path.tool(1, 40, ToolKind::face).spindle(2000);
  path.rapid(-25, 8, 5).line(-25, 8, -1).line(105, 8, -1).line(105, 40, -1).line(-25, 40, -1);
  path.rapid(-25, 40, 5);
  const Tree tree = recognise(path.recording(), block(0, 0, 80, 50, -20), Method::swept);
  ASSERT_EQ(tree.features.size(), 1U);
  EXPECT_EQ(tree.features[0].type, FeatureType::face);
  EXPECT_EQ(tree.features[0].strategy, Strategy::zig_zag);
  EXPECT_NEAR(tree.features[0].stepover.value_or(0), 32, kExact);
  EXPECT_NEAR(tree.features[0].volume(), 4000, kExact);
}

TEST(Milling, WhatIsLeftInTheCornersAndCutLaterIsTheSamePocket) {
  FlatPath path(10);
  two_loops(path, -2);
  path.tool(2, 4).spindle(6000);
  for (const double x : {12.0, 48.0}) {
    path.rapid(x, 16, 5).line(x, 16, -2).line(x, 12, -2).rapid(x, 12, 5);
  }
  const Tree tree = recognise(path.recording(), {}, Method::swept);
  ASSERT_EQ(tree.features.size(), 1U);
  ASSERT_EQ(tree.features[0].cuts.size(), 2U);
  EXPECT_EQ(tree.features[0].cuts[0].role, Cut::Role::rough);
  EXPECT_EQ(tree.features[0].cuts[1].role, Cut::Role::rest);
}

// The lines and the ways between them stand out by 2 µm; the last line's way goes along a wall.
TEST(Milling, AWallIsThatOfThePassAlongItWhereverOthersEnd) {
  FlatPath path(10);
  path.rapid(14.998, 15, 5).line(14.998, 15, -2);
  for (double y = 15; y < 35; y += 10) {
    path.line(45.002, y, -2).line(45.002, y + 5, -2);
    path.line(14.998, y + 5, -2).line(14.998, y + 10, -2);
  }
  path.line(45.002, 35, -2).line(45, 15, -2);
  path.line(45, 35, -2).line(15, 35, -2).line(15, 15, -2).line(45, 15, -2).rapid(45, 15, 5);
  const Tree tree = recognise(path.recording(), {}, Method::both);
  ASSERT_EQ(tree.features.size(), 1U);
  const Feature& pocket = tree.features[0];
  EXPECT_EQ(pocket.type, FeatureType::pocket);
  EXPECT_EQ(pocket.strategy, Strategy::zig_zag);
  EXPECT_EQ(pocket.milling, Milling::climb);
  const Layer& layer = pocket.layers.front();
  EXPECT_EQ(layer.contour.vertices.size(), 8U);
  EXPECT_NEAR(contour::area(layer.contour), 1200 - (4 - kPi) * 25, kExact);
  ASSERT_EQ(layer.nominal.vertices.size(), 4U);
  EXPECT_NEAR(contour::area(layer.nominal), 1200, kExact);
  EXPECT_NEAR(contour::length(layer.nominal), 140, kExact);
}

TEST(Milling, RoundThingsAboutOneAxisAreOneHole) {
  FeaturePath path;
  path.tool(1, 6.6, ToolKind::drill).spindle(2000);
  path.rapid(30, 20, 5).line(30, 20, -20).rapid(30, 20, 5);
  path.tool(2, 8).spindle(4000).rapid(30, 18.5, 5).line(30, 18.5, -5);
  path.arc(30, 18.5, -5, 30, 20, Direction::counterclockwise).rapid(30, 18.5, 5);
  const Tree tree = recognise(path.recording(), block(0, 0, 60, 40, -15), Method::swept);
  EXPECT_TRUE(tree.features.empty());
  ASSERT_EQ(tree.holes.size(), 1U);
  EXPECT_EQ(tree.holes[0].form, Hole::Form::counterbore);
  EXPECT_TRUE(tree.holes[0].through);
  ASSERT_EQ(tree.holes[0].steps.size(), 2U);
  EXPECT_NEAR(tree.holes[0].steps[1].diameter, 11, kExact);
}

// Words of inches put its middle beside the axis.
TEST(Milling, ACounterboreIsAboutTheAxisOfItsHoleAsFarAsWordsSayIt) {
  FlatPath path(6);
  path.rapid(35.002, 20, 5).line(35.002, 20, -3);
  path.arc(35.002, 20, -3, 30.002, 20.001, Direction::counterclockwise).rapid(35.002, 20, 5);
  path.line(32.002, 20, -3).arc(32.002, 20, -3, 30.002, 20.001, Direction::counterclockwise);
  path.rapid(32.002, 20, 5);
  path.tool(2, 6.6, ToolKind::drill).spindle(2000);
  path.rapid(30, 20, 5).line(30, 20, -12).rapid(30, 20, 5);
  const Tree tree = recognise(path.recording(), {}, Method::both);
  EXPECT_EQ(tree.features.size(), 0U);
  ASSERT_EQ(tree.holes.size(), 1U);
  EXPECT_EQ(tree.holes[0].form, Hole::Form::counterbore);
  EXPECT_NEAR(tree.holes[0].at.u, 30, kExact);
  EXPECT_NEAR(tree.holes[0].at.v, 20, kExact);
}

TEST(Milling, AReamedHoleIsAsWideAsTheReamerAndHasNoStep) {
  FeaturePath path;
  path.tool(1, 6.045, ToolKind::drill).spindle(3000);
  path.rapid(30, 20, 5).line(30, 20, -20).rapid(30, 20, 5);
  path.tool(2, 6.337, ToolKind::reamer).spindle(1000);
  path.rapid(30, 20, 5).line(30, 20, -15).line(30, 20, 5);
  const Tree tree = recognise(path.recording(), block(0, 0, 60, 40, -30), Method::swept);
  ASSERT_EQ(tree.holes.size(), 1U);
  EXPECT_EQ(tree.holes[0].form, Hole::Form::plain);
  EXPECT_NEAR(tree.holes[0].diameter, 6.337, kExact);
  EXPECT_NEAR(tree.holes[0].bottom, -20, kExact);
  EXPECT_EQ(tree.holes[0].steps.size(), 2U);
}

// Nobody has said how high it is there.
TEST(Milling, WhatIsFedAboveAnAssumedBlankIsNoAir) {
  FlatPath path(10);
  path.rapid(10, 10, 5).line(10, 10, 2).line(40, 10, 2).rapid(40, 10, 5);
  const Tree assumed = recognise(path.recording(), {}, Method::swept);
  ASSERT_EQ(assumed.unrecognised.size(), 1U);
  EXPECT_EQ(assumed.unrecognised[0].why, Unrecognised::Why::above_assumed_stock);
  const Tree known = recognise(path.recording(), block(0, 0, 60, 40, -20), Method::swept);
  ASSERT_EQ(known.unrecognised.size(), 1U);
  EXPECT_EQ(known.unrecognised[0].why, Unrecognised::Why::air);
}

TEST(Milling, AHelixLeadsIntoThePocketBelowIt) {
  FlatPath path(10);
  path.rapid(43, 30, 5).line(43, 30, 0);
  for (const double z : {-1.0, -2.0, -3.0, -3.0})
    path.arc(43, 30, z, 40, 30, Direction::counterclockwise);
  path.line(47, 30, -3).arc(47, 30, -3, 40, 30, Direction::counterclockwise).rapid(47, 30, 5);
  const Tree tree = recognise(path.recording(), {}, Method::swept);
  ASSERT_EQ(tree.features.size(), 1U);
  EXPECT_EQ(tree.features[0].entry.kind, Entry::Kind::helix);
  EXPECT_NEAR(tree.features[0].entry.pitch.value_or(0), 1, kExact);
  EXPECT_NEAR(tree.features[0].measures.round.value_or(FeatureMeasures::Round{}).diameter, 24,
              kExact);
}

TEST(Milling, ShortMovesUpAndDownAreASurface) {
  FeaturePath path;
  path.tool(1, 6, ToolKind::ball).spindle(5000).rapid(0, 0, 5).line(0, 0, -1);
  for (int i = 1; i <= 24; ++i) path.line(2.0 * i, 0, -1 - std::sin(i / 3.0));
  path.rapid(48, 0, 5);
  const Tree tree = recognise(path.recording(), {}, Method::swept);
  ASSERT_EQ(tree.features.size(), 1U);
  EXPECT_EQ(tree.features[0].type, FeatureType::surface);
  EXPECT_EQ(tree.features[0].editable, Editable::no);
}

TEST(Milling, NothingCutIsAnEmptyTree) {
  FlatPath path(10);
  path.rapid(1, 2, 3).rapid(4, 5, 6);
  const Tree tree = recognise(path.recording(), {}, Method::both);
  EXPECT_TRUE(tree.features.empty());
  EXPECT_TRUE(tree.operations.empty());
  EXPECT_TRUE(recognise(FeaturePath().recording(), {}, Method::both).features.empty());
}

}  // namespace
}  // namespace kerf::features
