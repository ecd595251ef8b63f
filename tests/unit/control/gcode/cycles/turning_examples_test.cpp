// The sequences of the turning cycles' own examples, move by move.
#include <gtest/gtest.h>

#include "control/gcode/cycles/pattern_passes.hpp"
#include "control/gcode/cycles/rough_passes.hpp"
#include "turning_bench.hpp"

namespace kerf::control {
namespace {

using test::cuts_of;
using test::difference;
using test::moves_of;
using test::read_moves;
using test::ShapeMaker;
using test::without_stops;

test::Moves rough(const TurningShape& shape, const RoughSettings& settings) {
  const auto passes = rough_passes(shape, settings);
  return without_stops(moves_of(*passes), shape.start);
}

TEST(LevelPasses, TheLastLevelTakesWhatIsLeft) {
  const auto shape = ShapeMaker({90, 3}, {36, 3})
                         .line({36, -15})
                         .line({50, -30})
                         .line({50, -45})
                         .line({90, -45})
                         .shape;
  const auto moves = rough(shape, {.depth_mm = 4, .retreat_mm = .8, .allowance = {.2, .3}});
  const std::string wanted = R"(
    R 90.6 3.2; R 82.6 3.2; F 82.6 -44.8; R 84.2 -44; R 84.2 3.2; R 74.6 3.2; F 74.6 -44.8;
    R 76.2 -44; R 76.2 3.2; R 66.6 3.2; F 66.6 -44.8; R 68.2 -44; R 68.2 3.2; R 58.6 3.2;
    F 58.6 -44.8; R 60.2 -44; R 60.2 3.2; R 50.6 3.2; F 50.6 -44.8; R 52.2 -44; R 52.2 3.2;
    R 42.6 3.2; F 42.6 -21.2286; R 44.2 -20.4286; R 44.2 3.2; R 36.6 3.2; F 36.6 -14.8;
    R 38.2 -14; R 38.2 3.2; R 36.6 3.2; F 36.6 -14.8; F 50.6 -29.8; F 50.6 -44.8; F 90.6 -44.8;
    R 90 3;)";
  EXPECT_EQ(difference(read_moves(wanted), moves), "");
}

TEST(LevelPasses, LevelsEndOnArcs) {
  const auto shape = ShapeMaker({64, 2}, {20, 2})
                         .line({20, -12})
                         .clockwise({28, -16}, 4)
                         .line({44, -16})
                         .counterclockwise({52, -20}, 4)
                         .line({52, -40})
                         .line({64, -40})
                         .shape;
  const auto moves = rough(shape, {.depth_mm = 3, .retreat_mm = .5, .allowance = {.1, .25}});
  const std::string wanted = R"(
    R 64.5 2.1; R 58.5 2.1; F 58.5 -39.9; R 59.5 -39.4; R 59.5 2.1; R 52.5 2.1; F 52.5 -39.9;
    R 53.5 -39.4; R 53.5 2.1; R 46.5 2.1; F 46.5 -16.027; R 47.5 -15.527; R 47.5 2.1;
    R 40.5 2.1; F 40.5 -15.9; R 41.5 -15.4; R 41.5 2.1; R 34.5 2.1; F 34.5 -15.9; R 35.5 -15.4;
    R 35.5 2.1; R 28.5 2.1; F 28.5 -15.9; R 29.5 -15.4; R 29.5 2.1; R 22.5 2.1; F 22.5 -14.5458;
    R 23.5 -14.0458; R 23.5 2.1; R 20.5 2.1; F 20.5 -11.9; R 21.5 -11.4; R 21.5 2.1; R 20.5 2.1;
    F 20.5 -11.9; CW 28.5 -15.9 28.5 -11.9; F 44.5 -15.9; CCW 52.5 -19.9 44.5 -19.9;
    F 52.5 -39.9; F 64.5 -39.9; R 64 2;)";
  EXPECT_EQ(difference(read_moves(wanted), moves), "");
}

TEST(LevelPasses, ABoreIsCutOutward) {
  const auto shape = ShapeMaker({18, 2}, {50, 2})
                         .line({50, -10})
                         .line({36, -24})
                         .line({36, -34})
                         .line({18, -34})
                         .shape;
  const auto moves = rough(shape, {.depth_mm = 2.5, .retreat_mm = .5, .allowance = {.1, -.2}});
  const std::string wanted = R"(
    R 17.6 2.1; R 22.6 2.1; F 22.6 -33.9; R 21.6 -33.4; R 21.6 2.1; R 27.6 2.1; F 27.6 -33.9;
    R 26.6 -33.4; R 26.6 2.1; R 32.6 2.1; F 32.6 -33.9; R 31.6 -33.4; R 31.6 2.1; R 37.6 2.1;
    F 37.6 -21.9; R 36.6 -21.4; R 36.6 2.1; R 42.6 2.1; F 42.6 -16.9; R 41.6 -16.4; R 41.6 2.1;
    R 47.6 2.1; F 47.6 -11.9; R 46.6 -11.4; R 46.6 2.1; R 49.6 2.1; F 49.6 -9.9; R 48.6 -9.4;
    R 48.6 2.1; R 49.6 2.1; F 49.6 -9.9; F 35.6 -23.9; F 35.6 -33.9; F 17.6 -33.9; R 18 2;)";
  EXPECT_EQ(difference(read_moves(wanted), moves), "");
}

TEST(LevelPasses, TowardPlusZ) {
  const auto shape =
      ShapeMaker({70, -82}, {30, -82}).line({30, -60}).line({46, -48}).line({70, -48}).shape;
  const auto moves = rough(shape, {.depth_mm = 5, .retreat_mm = 1, .allowance = {-.2, .25}});
  const std::string wanted = R"(
    R 70.5 -82.2; R 60.5 -82.2; F 60.5 -48.2; R 62.5 -49.2; R 62.5 -82.2; R 50.5 -82.2;
    F 50.5 -48.2; R 52.5 -49.2; R 52.5 -82.2; R 40.5 -82.2; F 40.5 -52.7; R 42.5 -53.7;
    R 42.5 -82.2; R 30.5 -82.2; F 30.5 -60.2; R 32.5 -61.2; R 32.5 -82.2; R 30.5 -82.2;
    F 30.5 -60.2; F 46.5 -48.2; F 70.5 -48.2; R 70 -82;)";
  EXPECT_EQ(difference(read_moves(wanted), moves), "");
}

TEST(LevelPasses, WhereTheShapeBeginsByFeedLevelsAreFedTo) {
  const auto shape = ShapeMaker({50, 2}, {30, 2}).by_feed().line({30, -18}).line({50, -26}).shape;
  const auto moves = rough(shape, {.depth_mm = 4, .retreat_mm = 1});
  const std::string wanted = R"(
    F 42 2; F 42 -22.8; R 44 -21.8; R 44 2; F 34 2; F 34 -19.6; R 36 -18.6; R 36 2; F 30 2;
    F 30 -18; R 32 -17; R 32 2; F 30 2; F 30 -18; F 50 -26; R 50 2;)";
  EXPECT_EQ(difference(read_moves(wanted), moves), "");
}

TEST(LevelPasses, InInches) {
  const auto shape =
      ShapeMaker({50.8, 2.54}, {25.4, 2.54}).line({25.4, -25.4}).line({50.8, -25.4}).shape;
  const auto moves =
      rough(shape, {.depth_mm = .063 * 25.4, .retreat_mm = 1.27, .allowance = {.127, .15875}});
  const std::string wanted = R"(
    R 51.1175 2.667; R 47.9171 2.667; F 47.9171 -25.273; R 50.4571 -24.003; R 50.4571 2.667;
    R 44.7167 2.667; F 44.7167 -25.273; R 47.2567 -24.003; R 47.2567 2.667; R 41.5163 2.667;
    F 41.5163 -25.273; R 44.0563 -24.003; R 44.0563 2.667; R 38.3159 2.667; F 38.3159 -25.273;
    R 40.8559 -24.003; R 40.8559 2.667; R 35.1155 2.667; F 35.1155 -25.273; R 37.6555 -24.003;
    R 37.6555 2.667; R 31.9151 2.667; F 31.9151 -25.273; R 34.4551 -24.003; R 34.4551 2.667;
    R 28.7147 2.667; F 28.7147 -25.273; R 31.2547 -24.003; R 31.2547 2.667; R 25.7175 2.667;
    F 25.7175 -25.273; R 28.2575 -24.003; R 28.2575 2.667; R 25.7175 2.667; F 25.7175 -25.273;
    F 51.1175 -25.273; R 50.8 2.54;)";
  EXPECT_EQ(difference(read_moves(wanted), moves), "");
}

TEST(LevelPasses, TheRetreatIsOfBothAxes) {
  const auto shape =
      ShapeMaker({60, 2}, {30, 2}).line({30, -20}).line({44, -30}).line({60, -30}).shape;
  const auto moves = rough(shape, {.depth_mm = 2.5, .retreat_mm = .7, .allowance = {.1, .2}});
  const std::string wanted = R"(
    R 60.4 2.1; R 55.4 2.1; F 55.4 -29.9; R 56.8 -29.2; R 56.8 2.1; R 50.4 2.1; F 50.4 -29.9;
    R 51.8 -29.2; R 51.8 2.1; R 45.4 2.1; F 45.4 -29.9; R 46.8 -29.2; R 46.8 2.1; R 40.4 2.1;
    F 40.4 -27.0429; R 41.8 -26.3429; R 41.8 2.1; R 35.4 2.1; F 35.4 -23.4714; R 36.8 -22.7714;
    R 36.8 2.1; R 30.4 2.1; F 30.4 -19.9; R 31.8 -19.2; R 31.8 2.1; R 30.4 2.1; F 30.4 -19.9;
    F 44.4 -29.9; F 60.4 -29.9; R 60 2;)";
  EXPECT_EQ(difference(read_moves(wanted), moves), "");
}

TEST(LevelPasses, OnTheOtherSideOfTheCentreLine) {
  const auto shape =
      ShapeMaker({-60, 2}, {-24, 2}).line({-24, -14}).line({-40, -22}).line({-60, -22}).shape;
  const auto moves = rough(shape, {.depth_mm = 3, .retreat_mm = .5, .allowance = {.1, -.2}});
  const std::string wanted = R"(
    R -60.4 2.1; R -54.4 2.1; F -54.4 -21.9; R -55.4 -21.4; R -55.4 2.1; R -48.4 2.1;
    F -48.4 -21.9; R -49.4 -21.4; R -49.4 2.1; R -42.4 2.1; F -42.4 -21.9; R -43.4 -21.4;
    R -43.4 2.1; R -36.4 2.1; F -36.4 -19.9; R -37.4 -19.4; R -37.4 2.1; R -30.4 2.1;
    F -30.4 -16.9; R -31.4 -16.4; R -31.4 2.1; R -24.4 2.1; F -24.4 -13.9; R -25.4 -13.4;
    R -25.4 2.1; R -24.4 2.1; F -24.4 -13.9; F -40.4 -21.9; F -60.4 -21.9; R -60 2;)";
  EXPECT_EQ(difference(read_moves(wanted), moves), "");
}

TEST(LevelPasses, FacingHasLevelsInZ) {
  const auto shape = ShapeMaker({84, 2}, {84, -24})
                         .line({60, -24})
                         .line({44, -12})
                         .line({30, -12})
                         .line({30, -1})
                         .shape;
  const auto moves = rough(
      shape, {.travel = Travel::along_x, .depth_mm = 4, .retreat_mm = .5, .allowance = {.2, .2}});
  const std::string wanted = R"(
    R 84.4 2.2; R 84.4 -1.8; F 30.4 -1.8; R 31.4 -1.3; R 84.4 -1.3; R 84.4 -5.8; F 30.4 -5.8;
    R 31.4 -5.3; R 84.4 -5.3; R 84.4 -9.8; F 30.4 -9.8; R 31.4 -9.3; R 84.4 -9.3; R 84.4 -13.8;
    F 47.0667 -13.8; R 48.0667 -13.3; R 84.4 -13.3; R 84.4 -17.8; F 52.4 -17.8; R 53.4 -17.3;
    R 84.4 -17.3; R 84.4 -21.8; F 57.7333 -21.8; R 58.7333 -21.3; R 84.4 -21.3; R 84.4 -23.8;
    F 60.4 -23.8; R 61.4 -23.3; R 84.4 -23.3; R 84.4 -23.8; F 60.4 -23.8; F 44.4 -11.8;
    F 30.4 -11.8; F 30.4 -0.8; R 84 2;)";
  EXPECT_EQ(difference(read_moves(wanted), moves), "");
}

TEST(PocketPasses, TwoPocketsAreFinishedOneAfterTheOther) {
  const auto shape = ShapeMaker({50, 2}, {30, 2})
                         .both_axes()
                         .line({30, -10})
                         .line({20, -15})
                         .line({20, -25})
                         .line({32, -30})
                         .line({32, -40})
                         .line({24, -44})
                         .line({24, -50})
                         .line({40, -55})
                         .line({46, -60})
                         .shape;
  const auto moves = rough(shape, {.depth_mm = 2, .retreat_mm = .5});
  const std::string wanted = R"(
    F 46 -60; F 50 -60; F 42 -56.6667; F 46 -60; F 38 -54.375; F 40 -55; F 42 -56.6667;
    F 34 -53.125; F 38 -54.375; F 30 -29.1667; F 32 -30; F 30 -10; F 26 -12; F 26 -27.5;
    F 30 -29.1667; F 26 -12; F 22 -14; F 22 -25.8333; F 26 -27.5; F 22 -14; F 20 -15; F 20 -25;
    F 22 -25.8333; F 32 -40; F 30 -41; F 30 -51.875; F 34 -53.125; F 30 -41; F 26 -43;
    F 26 -50.625; F 30 -51.875; F 26 -43; F 24 -44; F 24 -50; F 26 -50.625; F 30 -10; F 20 -15;
    F 20 -25; F 32 -30; F 32 -40; F 24 -44; F 24 -50; F 40 -55; F 46 -60;)";
  EXPECT_EQ(difference(read_moves(wanted), cuts_of(moves)), "");
}

TEST(PocketPasses, WallsAreClimbedAsFarAsTheyRise) {
  const auto shape = ShapeMaker({50, 2}, {16, 2})
                         .both_axes()
                         .line({16, 0})
                         .line({20, -2})
                         .line({20, -14})
                         .clockwise({28, -18}, 4)
                         .line({36, -18})
                         .counterclockwise({44, -22}, 4)
                         .line({44, -30})
                         .line({50, -30})
                         .shape;
  const auto moves = rough(shape, {.depth_mm = 4, .retreat_mm = .5, .allowance = {0, .2}});
  const std::string wanted = R"(
    F 42.4 -19.3542; CCW 44.4 -22 36.4 -22; F 34.4 -18; F 36.4 -18; CCW 42.4 -19.3542 36.4 -22;
    F 26.4 -17.873; CW 28.4 -18 28.4 -14; F 34.4 -18; F 18.4 -1; F 20.4 -2; F 16.4 0; F 18.4 -1;
    F 16.4 0; F 20.4 -2; F 20.4 -14; CW 28.4 -18 28.4 -14; F 36.4 -18; CCW 44.4 -22 36.4 -22;
    F 44.4 -30; F 50.4 -30;)";
  EXPECT_EQ(difference(read_moves(wanted), cuts_of(moves)), "");
}

TEST(PatternPasses, EachPassIsTheWholeShapeNearerToIt) {
  const auto shape =
      ShapeMaker({80, 6}, {30, 2}).line({30, -14}).clockwise({42, -20}, 6).line({60, -26}).shape;
  PatternPasses passes(shape, {.shift = {4, 8}, .passes = 3, .allowance = {.3, .4}});
  const std::string wanted = R"(
    R 96.8 10.3; R 46.8 6.3; F 46.8 -9.7; CW 58.8 -15.7 58.8 -9.7; F 76.8 -21.7; R 88.8 8.3;
    R 38.8 4.3; F 38.8 -11.7; CW 50.8 -17.7 50.8 -11.7; F 68.8 -23.7; R 80.8 6.3; R 30.8 2.3;
    F 30.8 -13.7; CW 42.8 -19.7 42.8 -13.7; F 60.8 -25.7; R 80 6;)";
  EXPECT_EQ(difference(read_moves(wanted), moves_of(passes)), "");
  EXPECT_EQ(passes.passes(), 3);
}

}  // namespace
}  // namespace kerf::control
