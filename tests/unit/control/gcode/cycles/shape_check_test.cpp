#include "control/gcode/cycles/shape_check.hpp"

#include <gtest/gtest.h>

#include "random_shape.hpp"
#include "turning_bench.hpp"

namespace kerf::control {
namespace {

using test::ShapeMaker;
using Reason = ShapeFault::Reason;

void expect_fault(const TurningShape& shape, Travel travel, Reason reason, std::uint32_t block) {
  const auto fault = check_shape(shape, travel, {});
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->reason, reason);
  EXPECT_EQ(fault->block, block);
}

TEST(CheckShape, BackAgainstTheTravel) {
  const auto shape =
      ShapeMaker({80, 2}, {40, 2}).line({40, -20}).line({50, -15}).line({80, -15}).shape;
  expect_fault(shape, Travel::along_z, Reason::not_monotone_first_axis, 2);
}

TEST(CheckShape, APocketWithoutBothAxes) {
  auto shape = ShapeMaker({80, 2}, {40, 2}).line({40, -20}).line({30, -30}).line({80, -30}).shape;
  expect_fault(shape, Travel::along_z, Reason::not_monotone_second_axis, 2);
  shape.both_axes = true;
  EXPECT_FALSE(check_shape(shape, Travel::along_z, {}));
}

TEST(CheckShape, FacingHasNoPocketsWhateverItsFirstBlock) {
  const auto shape = ShapeMaker({80, 2}, {80, -20})
                         .both_axes()
                         .line({60, -20})
                         .line({40, -24})
                         .line({20, 0})
                         .shape;
  expect_fault(shape, Travel::along_x, Reason::not_monotone_second_axis, 2);
}

TEST(CheckShape, AnArcThatTurnsBackBetweenItsEnds) {
  // More than a quarter each: beyond Z-20 and back, or below X40 and up.
  expect_fault(ShapeMaker({80, 2}, {40, 2}).line({40, -10}).clockwise({66, -15}, 8).shape,
               Travel::along_z, Reason::not_monotone_first_axis, 2);
  expect_fault(ShapeMaker({80, 2}, {40, 2}).line({40, -10}).clockwise({44, -22}, 8).shape,
               Travel::along_z, Reason::not_monotone_second_axis, 2);
}

TEST(CheckShape, BeyondTheStart) {
  const auto above = ShapeMaker({80, 2}, {40, 2}).line({40, -20}).line({82, -30}).shape;
  expect_fault(above, Travel::along_z, Reason::outside_start, 2);
  const auto behind =
      ShapeMaker({80, 2}, {40, 3}).both_axes().line({40, -20}).line({80, -30}).shape;
  expect_fault(behind, Travel::along_z, Reason::outside_start, 0);
}

TEST(CheckShape, TheToleranceIsOfTheAxisOfThePlane) {
  const auto along_z =
      ShapeMaker({80, 2}, {40, 2}).line({40, -20}).line({50, -19.7}).line({80, -19.7}).shape;
  EXPECT_FALSE(check_shape(along_z, Travel::along_z, {0.3, 0}));
  EXPECT_TRUE(check_shape(along_z, Travel::along_z, {0.29, 1}));
  const auto along_x = ShapeMaker({80, 2}, {80, -20}).line({40, -20}).line({40.6, -10}).shape;
  EXPECT_FALSE(check_shape(along_x, Travel::along_x, {0, 0.3}));
  EXPECT_TRUE(check_shape(along_x, Travel::along_x, {1, 0.29}));
}

TEST(CheckShape, SmallStepsBackAddUp) {
  ShapeMaker maker({80, 2}, {40, 2});
  maker.line({40, -20});
  for (int i = 1; i < 6; ++i) maker.line({40. + i, -20 + 0.1 * i});
  const auto fault = check_shape(maker.shape, Travel::along_z, {0.3, 0});
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->block, 5);
}

TEST(CheckShape, FindsNothingInShapesThatCanBeTurned) {
  for (unsigned i = 0; i < 2000; ++i) {
    const bool pockets = i % 2 == 0;
    const bool exchanged = !pockets && i % 4 == 1;
    const auto shape = test::ShapeDice(test::kSeed + i).shape(pockets);
    const auto placed = place(shape, test::quadrants(exchanged)[i / 4 % 4], pockets);
    const auto travel = exchanged ? Travel::along_x : Travel::along_z;
    ASSERT_FALSE(check_shape(placed, travel, {})) << text(shape);
  }
}

}  // namespace
}  // namespace kerf::control
