#include "control/gcode/cycles/monotone_piece.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "turning_bench.hpp"

namespace kerf::control {
namespace {

using geometry::Vec2;
using test::ShapeMaker;

std::vector<MonotonePiece> pieces_of(const TurningShape& shape) {
  return monotone_pieces(shape, TurningFrame(shape, Travel::along_z), {});
}

TEST(MonotonePieces, OfACircleAreItsQuarters) {
  const auto pieces = pieces_of(ShapeMaker({50, 2}, {30, 0}).circle({30, -5}).shape);
  ASSERT_EQ(pieces.size(), 4U);
  for (const MonotonePiece& piece : pieces)
    EXPECT_NEAR(length(piece.to - piece.from), 5 * std::sqrt(2), 1e-12);
}

TEST(MonotonePieces, EndExactlyWhereTheShapeDoes) {
  // A quarter, and a bit more or less.
  for (const double more : {-5e-10, -1e-13, 0.0, 1e-13, 5e-10}) {
    TurningShape shape{.start = {0, 30}, .pieces = {}};
    const Vec2 to{-5, 15 + more};
    shape.pieces = {
        {.from = {0, 10}, .to = to, .is_arc = true, .clockwise = true, .centre = {0, 15}}};
    const auto pieces = pieces_of(shape);
    ASSERT_EQ(pieces.size(), 1U) << more;
    EXPECT_EQ(pieces.back().to, (Vec2{5, to.v}));
  }
}

TEST(MonotonePieces, WithoutLengthAreLeftOut) {
  const auto shape = ShapeMaker({50, 2}, {30, 2})
                         .line({30, 2})
                         .line({30, -5})
                         .circle({30, -5})
                         .line({30, -5})
                         .shape;
  EXPECT_EQ(pieces_of(shape).size(), 1U);
}

TEST(MonotonePieces, AtAHeightBeyondAnEndAreAtTheEnd) {
  const MonotonePiece line{.from = {1, 2}, .to = {3, 6}};
  EXPECT_EQ(line.at_height(4), (Vec2{2, 4}));
  EXPECT_EQ(line.at_height(0), line.from);
  EXPECT_EQ(line.at_height(9), line.to);
  const MonotonePiece flat{.from = {1, 2}, .to = {3, 2}};
  EXPECT_EQ(flat.at_height(2), flat.from);
}

TEST(MonotonePieces, AtAHeightOfAnArcAreOnItsCircle) {
  const MonotonePiece arc{
      .from = {0, 0}, .to = {5, 5}, .is_arc = true, .clockwise = false, .centre = {0, 5}};
  EXPECT_NEAR(arc.at_height(1).u, 3, 1e-15);
  EXPECT_NEAR(arc.at_height(2).u, 4, 1e-15);
}

}  // namespace
}  // namespace kerf::control
