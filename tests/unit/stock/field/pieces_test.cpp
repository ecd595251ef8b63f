// What of a height field hangs together.
#include "stock/field/pieces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "stock/field/field_jobs.hpp"

namespace kerf::stock::field {
namespace {

TEST(FieldPieces, ASlotThroughTheStockMakesTwo) {
  Job job({{0, 0, -10}, {60, 40, 0}}, 0.5, flat(8));
  EXPECT_EQ(job.field().pieces().size(), 1U);
  job.at({20, -10, 0}).to({20, -10, -10}).to({20, 50, -10});
  const auto pieces = job.field().pieces();
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(pieces[0].volume_mm3, 36 * 40 * 10, 1e-6);
  EXPECT_NEAR(pieces[1].volume_mm3, 16 * 40 * 10, 1e-6);
  EXPECT_NEAR(pieces[0].extents.low.x, 24, 1e-9);
  EXPECT_NEAR(pieces[1].extents.high.x, 16, 1e-9);
  EXPECT_TRUE(pieces[0].held && pieces[1].held);
}

TEST(FieldPieces, AThinFloorHoldsThem) {
  Job job({{0, 0, -10}, {60, 40, 0}}, 0.5, flat(8));
  job.at({20, -10, 0}).to({20, -10, -9.9}).to({20, 50, -9.9});
  EXPECT_EQ(job.field().pieces().size(), 1U);
}

// A lying cylinder stands on its line alone: what is beside that is not on the bottom.
TEST(FieldPieces, WhatDoesNotTouchTheBottomIsNotHeld) {
  const Grid grid = grid_of({{-10, 0, -10}, {10, 10, 10}}, 0.5);
  HeightField field(
      grid,
      [](double x, double) -> Column {
        const double bottom = x < 0 ? -10 : 0;
        return {bottom, x < 0 ? -1.0 : 5.0};
      },
      1);
  const auto pieces = field.pieces();
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_TRUE(pieces[0].held);
  EXPECT_FALSE(pieces[1].held);
}

}  // namespace
}  // namespace kerf::stock::field
