#include "control/gcode/cycles/pattern_passes.hpp"

#include <gtest/gtest.h>

#include "turning_bench.hpp"

namespace kerf::control {
namespace {

using test::difference;
using test::moves_of;
using test::read_moves;
using test::ShapeMaker;

const TurningShape kShape = ShapeMaker({80, 6}, {30, 2}).line({30, -14}).line({60, -26}).shape;

TEST(PatternPasses, OnePassHasTheAllowanceAlone) {
  const std::string wanted = "R 80.8 6.3; R 30.8 2.3; F 30.8 -13.7; F 60.8 -25.7; R 80 6";
  for (const std::uint32_t count : {0U, 1U}) {
    PatternPasses passes(kShape, {.shift = {4, 8}, .passes = count, .allowance = {.3, .4}});
    EXPECT_EQ(difference(read_moves(wanted), moves_of(passes)), "");
    EXPECT_EQ(passes.passes(), 1);
  }
}

TEST(PatternPasses, GoToTheShapeByFeedWhereItBeginsSo) {
  auto shape = kShape;
  shape.approach_is_rapid = false;
  PatternPasses passes(shape, {});
  const std::string wanted = "R 80 6; F 30 2; F 30 -14; F 60 -26; R 80 6";
  EXPECT_EQ(difference(read_moves(wanted), moves_of(passes)), "");
}

TEST(PatternPasses, OnlyTheLastIsOfTheShapesBlocks) {
  PatternPasses passes(kShape, {.shift = {4, 8}, .passes = 2});
  std::vector<std::uint32_t> blocks;
  for (const TurningMove& move : moves_of(passes)) blocks.push_back(move.block);
  constexpr auto kCycle = kCycleBlock;
  EXPECT_EQ(blocks,
            (std::vector<std::uint32_t>{kCycle, kCycle, kCycle, kCycle, kCycle, 0, 1, 2, kCycle}));
}

TEST(PatternPasses, AShapeWithoutPiecesIsThereAndBack) {
  PatternPasses passes({.start = {2, 40}, .pieces = {}}, {.shift = {4, 8}, .passes = 2});
  EXPECT_EQ(moves_of(passes).size(), 5U);
}

}  // namespace
}  // namespace kerf::control
