// What the examples of the cycles do not show: whose move it is, shapes that are hardly any, shapes
// that nobody has checked, very large ones.
#include "control/gcode/cycles/rough_passes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "turning_bench.hpp"

namespace kerf::control {
namespace {

using test::cuts_of;
using test::difference;
using test::Moves;
using test::read_moves;
using test::ShapeMaker;
using test::XZ;

constexpr auto kRapid = TurningMove::Kind::rapid;
constexpr auto kFeed = TurningMove::Kind::feed;

// Every one with numbers for coordinates, the last at the start.
Moves rough(const TurningShape& shape, const RoughSettings& settings) {
  const auto passes = rough_passes(shape, settings);
  Moves moves = test::moves_of(*passes);
  for (const TurningMove& move : moves)
    EXPECT_TRUE(std::isfinite(move.to.u) && std::isfinite(move.to.v)) << test::text(moves);
  EXPECT_EQ(moves.back().to, shape.start);
  EXPECT_EQ(moves.back().kind, kRapid);
  TurningMove none;
  EXPECT_FALSE(passes->next(none));
  return moves;
}

// Feed moves of the cycle's own, without those that go nowhere.
Moves roughing_cuts(const TurningShape& shape, const RoughSettings& settings) {
  Moves cuts;
  for (const TurningMove& move : test::without_stops(rough(shape, settings), shape.start)) {
    if (move.kind == kFeed && move.block == kCycleBlock) cuts.push_back(move);
  }
  return cuts;
}

TEST(RoughPasses, AreOfTheCyclesBlockAndTheLastPassOfTheShapes) {
  const auto shape = ShapeMaker({50, 2}, {40, 2}).line({40, -10}).line({50, -20}).shape;
  std::vector<std::uint32_t> blocks;
  for (const TurningMove& move : rough(shape, {.depth_mm = 5})) blocks.push_back(move.block);
  constexpr auto kCycle = kCycleBlock;
  // C; level, cut, retreat, back; P0, in two moves of which one has no length; the shape; home.
  EXPECT_EQ(blocks, (std::vector<std::uint32_t>{kCycle, kCycle, kCycle, kCycle, kCycle, 0, 0, 1, 2,
                                                kCycle}));
}

TEST(RoughPasses, CountTheLevelsAndNotTheWayAlongTheShape) {
  const auto shape = ShapeMaker({50, 2}, {40, 2}).line({40, -10}).line({50, -20}).shape;
  const auto passes = rough_passes(shape, {.depth_mm = 2});
  (void)test::moves_of(*passes);
  EXPECT_EQ(passes->passes(), 3);
}

TEST(RoughPasses, RoundingMakesNoLevel) {
  for (int i = 1; i < 200; ++i) {
    const double depth = i * 0.1;
    const auto shape = ShapeMaker({100 + 6 * depth, 2}, {100, 2}).line({100, -10}).shape;
    const auto passes = rough_passes(shape, {.depth_mm = depth, .allowance = {0.1, 0.7}});
    (void)test::moves_of(*passes);
    ASSERT_EQ(passes->passes(), 3) << depth;
  }
}

TEST(RoughPasses, AShapeWithoutPiecesIsOnlyTheWayOutAndBack) {
  const TurningShape shape{.start = {2, 25}, .pieces = {}};
  for (const bool both : {false, true}) {
    TurningShape either = shape;
    either.both_axes = both;
    for (const TurningMove& move : rough(either, {.allowance = {0.1, 0.2}}))
      EXPECT_EQ(move.kind, kRapid);
  }
}

TEST(RoughPasses, ShapesThatAreHardlyAnyHaveAnEnd) {
  const ShapeMaker shapes[] = {
      ShapeMaker({50, 2}, {50, 2}).line({50, 2}),                    // a point
      ShapeMaker({50, 2}, {30, 2}).line({30, 2}).line({30, 2}),      // below the start
      ShapeMaker({50, 2}, {30, 2}).line({40, 2}).line({60, 2}),      // only a wall
      ShapeMaker({50, 2}, {30, -2}).line({10, -2}).line({60, -2}),   // down and up
      ShapeMaker({50, 2}, {50, 2}).line({50, -20}),                  // on the first level
      ShapeMaker({50, 2}, {30, 2}).line({30, -20}),                  // on the last level
      ShapeMaker({50, 2}, {30, 2}).circle({30, -8}),                 // full circles
      ShapeMaker({50, 2}, {30, 2}).circle({30, 2}).line({40, -5}),   // without radius
      ShapeMaker({50, 2}, {30, 2}).circle({40, 2}).circle({40, 2}),  // twice
      ShapeMaker({50, 2}, {30, 12}).line({30, 5}).line({60, 5}),     // behind the start
      ShapeMaker({50, 2}, {30, 2}).line({90, -5}).line({20, -9}),    // beyond it
      ShapeMaker({50, 2}, {30, 2}).line({30, -5}).line({40, 4}).line({20, -9}),  // back and on
      ShapeMaker({50, 2}, {30, 2}).line({30, -9}).line({30, 2}),                 // and back
      ShapeMaker({50, 2}, {30, 2}).clockwise({40, -3}, 5).counterclockwise({30, 2}, 5),
      ShapeMaker({50, 2}, {30, 2}).clockwise({30, -8}, 5).clockwise({30, 2}, -5),
  };
  for (const ShapeMaker& maker : shapes) {
    for (const bool both : {false, true}) {
      for (const Travel travel : {Travel::along_z, Travel::along_x}) {
        for (const double depth : {0.005, 0.5, 2.0, 1000.0}) {
          TurningShape shape = maker.shape;
          shape.both_axes = both;
          const Moves moves = rough(shape, {.travel = travel, .depth_mm = depth});
          EXPECT_GE(moves.size(), shape.pieces.size() + 2);
        }
      }
    }
  }
}

TEST(RoughPasses, ADepthOfNothingHasAnEnd) {
  const auto shape = ShapeMaker({30.002, 2}, {30, 2}).line({30, -20}).shape;
  const auto passes = rough_passes(shape, {.depth_mm = 0});
  (void)test::moves_of(*passes);
  EXPECT_EQ(passes->passes(), 1000);
}

// N20 G00 Z0.1 in real programs.
TEST(LevelPasses, AWayBackAtTheEndIsDrivenButEndsNoLevel) {
  const auto shape =
      ShapeMaker({50, 2}, {30, 2}).line({30, -20}).line({46, -20}).line({46, 0.1}).shape;
  const Moves moves = rough(shape, {.depth_mm = 5, .retreat_mm = 1});
  EXPECT_EQ(
      difference(read_moves("F 40 -20; F 30 -20; F 30 -20; F 46 -20; F 46 .1"), cuts_of(moves)),
      "");
}

TEST(LevelPasses, AShapeThatComesBackToItsBeginningIsCutTowardItsFarthestPoint) {
  const auto shape = ShapeMaker({50, 2}, {30, 2}).line({30, -20}).line({50, 2}).shape;
  EXPECT_EQ(difference(read_moves("F 40 -20; F 30 -20"), roughing_cuts(shape, {.depth_mm = 5})),
            "");
}

TEST(LevelPasses, AWallThatLeansBackInTheMiddleEndsLevelsWhereItIs) {
  const auto shape =
      ShapeMaker({80, 2}, {40, 2}).line({40, -20}).line({50, -15}).line({80, -15}).shape;
  EXPECT_EQ(difference(read_moves("F 62.5 -15; F 45 -17.5; F 40 -20"),
                       roughing_cuts(shape, {.depth_mm = 8.75})),
            "");
}

TEST(LevelPasses, NothingIsCutBackward) {
  const auto shape = ShapeMaker({50, 2}, {30, 12}).line({30, 5}).line({60, 5}).shape;
  EXPECT_EQ(difference({}, roughing_cuts(shape, {.depth_mm = 3})), "");
}

TEST(LevelPasses, AnArcWithTwoRadiiIsCrossedOnTheOneBetween) {
  // From 10 below its centre to 10.01 beside it, as rounded I and K make it.
  TurningShape shape{.start = {0, 30}, .pieces = {}};
  shape.pieces = {
      {.from = {0, 10}, .to = {-10.01, 20}, .is_arc = true, .clockwise = true, .centre = {0, 20}}};
  const Moves cuts = roughing_cuts(shape, {.depth_mm = 5});
  ASSERT_EQ(cuts.size(), 3);
  EXPECT_NEAR(cuts[0].to.u, -10.01, 1e-12);
  EXPECT_NEAR(cuts[1].to.u, -10.01, 1e-12);
  EXPECT_NEAR(cuts[2].to.u, -std::sqrt(10.005 * 10.005 - 25), 1e-12);
}

TEST(LevelPasses, FacingKnowsNoPockets) {
  const auto shape = ShapeMaker({80, 2}, {80, -20})
                         .both_axes()
                         .line({60, -20})
                         .line({40, -24})
                         .line({20, 0})
                         .shape;
  const auto passes = rough_passes(shape, {.travel = Travel::along_x, .depth_mm = 11});
  (void)test::moves_of(*passes);
  EXPECT_EQ(passes->passes(), 2);
}

TEST(PocketPasses, EachPocketHasADeepestLevelOfItsOwn) {
  const auto shape = ShapeMaker({34, 2}, {30, 2})
                         .both_axes()
                         .line({30, -5})
                         .line({24, -5})
                         .line({24, -10})
                         .line({30, -10})
                         .line({30, -15})
                         .line({20, -15})
                         .line({20, -20})
                         .line({34, -20})
                         .shape;
  const std::string wanted =
      "F 30 -20; F 34 -20;"
      "F 30 -5; F 26 -5; F 26 -10; F 30 -10; F 26 -5; F 24 -5; F 24 -10; F 26 -10;"
      "F 30 -15; F 26 -15; F 26 -20; F 30 -20; F 26 -15; F 22 -15; F 22 -20; F 26 -20;"
      "F 22 -15; F 20 -15; F 20 -20; F 22 -20";
  EXPECT_EQ(difference(read_moves(wanted), roughing_cuts(shape, {.depth_mm = 2})), "");
}

TEST(PocketPasses, ABottomBetweenTwoLevelsThatIsNotTheDeepestOfItsPartIsLeft) {
  // To 24, over a hump of 25, to 20: at the level of 26 they are one part, at 22 there is only one.
  const auto shape = ShapeMaker({34, 2}, {30, 2})
                         .both_axes()
                         .line({30, -5})
                         .line({24, -5})
                         .line({24, -10})
                         .line({25, -10})
                         .line({25, -12})
                         .line({20, -12})
                         .line({20, -16})
                         .line({34, -16})
                         .shape;
  const std::string wanted =
      "F 30 -16; F 34 -16; F 30 -5; F 26 -5; F 26 -16; F 30 -16;"
      "F 25 -12; F 22 -12; F 22 -16; F 26 -16; F 22 -12; F 20 -12; F 20 -16; F 22 -16";
  EXPECT_EQ(difference(read_moves(wanted), roughing_cuts(shape, {.depth_mm = 2})), "");
}

TEST(PocketPasses, TheToolRisesByTheRetreatOverTheLevelAboveWhereItIsNotThatHigh) {
  // Two pockets to a point at 20; the hump of 30 between them is below the level of 32.
  const auto shape = ShapeMaker({40, 2}, {30, 2})
                         .both_axes()
                         .line({30, -5})
                         .line({20, -10})
                         .line({30, -15})
                         .line({20, -20})
                         .line({30, -25})
                         .line({40, -25})
                         .shape;
  const std::string wanted =
      "R 32 2; F 32 -25; F 40 -25; R 41 -25;"
      "R 41 -5; F 30 -5; F 24 -8; F 24 -12; F 30 -15; R 31 -15;"
      "R 33 -15; F 30 -15; F 24 -18; F 24 -22; F 30 -25; F 32 -25; R 33 -25;"
      "R 40 -25; R 40 2; R 30 2;"
      "F 30 -5; F 20 -10; F 30 -15; F 20 -20; F 30 -25; F 40 -25; R 40 2";
  const Moves moves = rough(shape, {.depth_mm = 4, .retreat_mm = 0.5});
  EXPECT_EQ(difference(read_moves(wanted), test::without_stops(moves, shape.start)), "");
}

TEST(PocketPasses, WhereTheShapeBeginsAsHighAsTheStartTheWorkIsWhereThePocketIs) {
  const auto shape = ShapeMaker({20, 2}, {20, -1}).both_axes().line({30, -6}).line({20, -11}).shape;
  EXPECT_EQ(difference(read_moves("F 20 -1; F 26 -4; F 26 -8; F 20 -11"),
                       roughing_cuts(shape, {.depth_mm = 3})),
            "");
}

TEST(PocketPasses, AnArcWithoutLengthIsALine) {
  // The level is 3e-10 below the edges of a round groove.
  const auto shape =
      ShapeMaker({44, 2}, {40, 2}).both_axes().line({40, -5}).clockwise({40, -15}, 5).shape;
  const Moves moves = rough(shape, {.depth_mm = 2 + 3e-10});
  for (std::size_t i = 1; i < moves.size(); ++i) {
    if (!moves[i].is_arc) continue;
    EXPECT_GT(length(moves[i].to - moves[i - 1].to), 1e-6) << i << " of " << test::text(moves);
  }
}

TEST(PocketPasses, AFlatBeforeTheShapeIsCutAtItsHeight) {
  const auto shape = ShapeMaker({40, 5}, {30, 0}).both_axes().line({30, -5}).line({40, -10}).shape;
  const Moves moves =
      test::without_stops(rough(shape, {.depth_mm = 5, .retreat_mm = 1}), shape.start);
  EXPECT_EQ(difference(read_moves("R 30 5; F 30 -5; F 40 -10; R 42 -10; R 40 -10; R 40 5; R 30 5;"
                                  "R 30 0; F 30 -5; F 40 -10; R 40 5"),
                       moves),
            "");
}

// A comb of pockets.
TurningShape comb(int teeth) {
  ShapeMaker maker(XZ{420, 2}, XZ{310, 2});
  maker.both_axes();
  for (int i = 0; i < teeth; ++i) {
    const double z = -0.5 * i;
    maker.line({310, z}).line({25. + i % 11, z - 0.1}).line({25. + i % 11, z - 0.3});
    maker.line({310, z - 0.4});
  }
  return maker.line({420, -0.5 * teeth}).shape;
}

TEST(PocketPasses, OfALargeCombAreAsManyAsItsTeethHaveLevels) {
  constexpr int kTeeth = 20'000;
  const auto passes = rough_passes(comb(kTeeth), {.depth_mm = 55});  // 310, 200, 90, the bottoms
  TurningMove move;
  std::uint64_t moves = 0;
  while (passes->next(move)) ++moves;
  EXPECT_EQ(passes->passes(), 1 + 3 * kTeeth);
  EXPECT_LE(moves, 8 * passes->passes() + 4 * kTeeth + 10);
}

TEST(LevelPasses, AreFourMovesEachHoweverLargeTheShape) {
  constexpr int kSteps = 50'000;
  ShapeMaker maker(XZ{420, 2}, XZ{20, 2});
  for (int i = 0; i < kSteps; ++i) {
    maker.line({20 + 400.0 * i / kSteps, -0.01 * i - 0.01});
    maker.line({20 + 400.0 * (i + 1) / kSteps, -0.01 * i - 0.01});
  }
  const auto passes = rough_passes(maker.shape, {.depth_mm = 0.02});
  TurningMove move;
  std::uint64_t moves = 0;
  while (passes->next(move)) ++moves;
  EXPECT_EQ(passes->passes(), 10'000);
  EXPECT_EQ(moves, 1 + 4 * passes->passes() + 2 + 2 * kSteps + 1);
}

// Each level has one part only, so that none stays open behind it.
TEST(PocketPasses, LevelsInEachOtherMayBeVeryMany) {
  const auto shape =
      ShapeMaker({420, 2}, {400, 2}).both_axes().line({20, -100}).line({400, -200}).shape;
  const auto passes = rough_passes(shape, {.depth_mm = 0.0005});
  TurningMove move;
  while (passes->next(move)) continue;
  EXPECT_NEAR(static_cast<double>(passes->passes()), 400'000, 1);
}

}  // namespace
}  // namespace kerf::control
