// Blocks along a contour, for another contour: what stays, what comes in, where they begin and end.
#include "features/rewrite/followed_contour.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "feature_path.hpp"
#include "features/path/programmed.hpp"
#include "features/rewrite/element_map.hpp"
#include "features/tree/normal_form.hpp"

namespace kerf::features {
namespace {

using contour::Contour;

Contour of(std::vector<contour::Vertex> vertices) {
  return normal_form({std::move(vertices), true});
}
Contour rectangle(double width, double height) {
  return of({{{0, 0}}, {{width, 0}}, {{width, height}}, {{0, height}}});
}

/// Round a rectangle of 40 × 30 clockwise, run in and out by 10.
void go_round_rectangle(test::FeaturePath& path) {
  path.tool(1, 10).rapid(-20, -20, -4).line(0, -10, -4);
  path.line(0, 30, -4).line(40, 30, -4).line(40, 0, -4).line(-10, 0, -4).line(-20, -20, -4);
}
constexpr Span kAllRows{0, 6};

ContourChain chain_of(const test::FeaturePath& path, const Contour& contour) {
  return chain_along(path.recording(), kAllRows, contour).value();
}

TEST(ContourChain, IsFoundAgainstTheSenseInWhichTheContourIsTold) {
  test::FeaturePath path;
  go_round_rectangle(path);
  const ContourChain chain = chain_of(path, rectangle(40, 30));
  EXPECT_EQ(chain.rows, (Span{2, 5}));
  EXPECT_TRUE(chain.is_reversed);
  EXPECT_EQ(chain.steps, 3U);
  EXPECT_EQ(chain.begin, (Vec2{0, -10}));
  EXPECT_EQ(chain.end, (Vec2{-10, 0}));
}

TEST(ContourChain, RowsThatLeaveTheContourAreNone) {
  test::FeaturePath path;
  path.tool(1, 10).rapid(0, 0, -4).line(0, 30, -4).line(20, 20, -4).line(40, 30, -4);
  path.line(40, 0, -4);
  EXPECT_FALSE(chain_along(path.recording(), {0, 4}, rectangle(40, 30)));
}

TEST(MappedElements, ThoseThatLieAlongEachOtherAreOneAndAGapOfEqualSizeIsPaired) {
  const auto map = mapped_elements(rectangle(40, 30), rectangle(40, 36));
  ASSERT_EQ(map.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(map[i], i);
}

TEST(MappedElements, WhereOneComesInTheOthersKeepTheirs) {
  const Contour cut = of({{{0, 0}}, {{36, 0}}, {{40, 5}}, {{40, 30}}, {{0, 30}}});
  const auto map = mapped_elements(rectangle(40, 30), cut);
  EXPECT_EQ(map[0], 0U);
  EXPECT_EQ(map[1], 2U);
  EXPECT_EQ(map[2], 3U);
  EXPECT_EQ(map[3], 4U);
}

TEST(FollowedContour, ACornerBecomesAnArcBetweenTwoBlocksThatStay) {
  test::FeaturePath path;
  go_round_rectangle(path);
  const double quarter = std::numbers::sqrt2 - 1;
  const Contour rounded = of({{{0, 0}}, {{40, 0}}, {{40, 24}, quarter}, {{34, 30}}, {{0, 30}}});
  const auto made = followed(path.recording(), chain_of(path, rectangle(40, 30)), rounded, {});
  ASSERT_TRUE(made);
  ASSERT_EQ(made->rows.size(), 5U);
  EXPECT_EQ(made->rows[1].was, 3U);
  EXPECT_NEAR(made->rows[1].to.x, 34, 1e-9);
  ASSERT_TRUE(made->rows[2].arc);
  EXPECT_FALSE(made->rows[2].was);
  EXPECT_NEAR(made->rows[2].arc->centre.u, 34, 1e-6);
  EXPECT_NEAR(made->rows[2].arc->sweep_rad, -std::numbers::pi / 2, 1e-6);
  EXPECT_EQ(made->rows[4].was, 5U);
  EXPECT_EQ(made->begin.is, made->begin.was);
  EXPECT_EQ(made->end.is, made->end.was);
}

TEST(FollowedContour, AWallThatMovesTakesTheRunInAlong) {
  test::FeaturePath path;
  go_round_rectangle(path);
  const Contour wider = of({{{-6, 0}}, {{40, 0}}, {{40, 30}}, {{-6, 30}}});
  const auto made = followed(path.recording(), chain_of(path, rectangle(40, 30)), wider, {});
  ASSERT_TRUE(made);
  EXPECT_EQ(made->begin.is, (Vec2{-6, -10}));
  EXPECT_EQ(made->rows.size(), 4U);
}

TEST(FollowedContour, TheLastBlockStaysTheLastWhereItIsNamed) {
  test::FeaturePath path;
  go_round_rectangle(path);
  const Contour bent = of({{{0, 0}}, {{40, 0}}, {{40, 15}}, {{30, 15}}, {{30, 30}}, {{0, 30}}});
  const auto made =
      followed(path.recording(), chain_of(path, rectangle(40, 30)), bent, {.last = true});
  ASSERT_TRUE(made);
  ASSERT_EQ(made->rows.size(), 6U);
  EXPECT_EQ(made->rows.back().was, 5U);
}

/// As the control leads a tool of 10 mm on the left of that rectangle, the last move too late.
void go_beside_rectangle(test::FeaturePath& path) {
  path.tool(1, 10).rapid(-20, -20, -4);
  path.now.compensation = Compensation::left;
  path.now.beside = {.to_left_mm = 5};
  path.line(-5, -10, -4).line(-5, 35, -4).line(45, 35, -4).line(45, -5, -4);
  path.now = {};
  path.line(-10, -5, -4).line(-20, -20, -4);
}

TEST(AsProgrammed, CornersAreWhereTheBlocksNameThem) {
  test::FeaturePath path;
  go_beside_rectangle(path);
  const Recording made = as_programmed(path.recording());
  const std::vector<Vec2> wanted{{-20, -20}, {0, -10}, {0, 30},   {40, 30},
                                 {40, 0},    {-10, 0}, {-20, -20}};
  ASSERT_EQ(made.count(), wanted.size());
  for (std::uint32_t row = 0; row < made.count(); ++row)
    EXPECT_LT(geometry::length(made.flat_to(row) - wanted[row]), 1e-9) << row;
  EXPECT_TRUE(made.state_of(made.moves[5]).is_compensated());
  EXPECT_FALSE(made.state_of(made.moves[6]).is_compensated());
}

TEST(AsProgrammed, AnArcKeepsItsCentreAndIsAsLargeAsItsBlockSays) {
  test::FeaturePath path;
  path.tool(1, 10).rapid(-20, -20, -4);
  path.now.beside = {.to_left_mm = 5};
  path.line(-5, -10, -4).line(-5, 24, -4);
  path.arc(6, 35, -4, 6, 24, motion::Direction::clockwise).line(40, 35, -4);
  path.now = {};
  path.line(60, 35, -4).line(80, 50, -4);
  const Recording made = as_programmed(path.recording());
  EXPECT_LT(geometry::length(made.flat_to(2) - Vec2{0, 24}), 1e-9);
  EXPECT_LT(geometry::length(made.flat_to(3) - Vec2{6, 30}), 1e-9);
  EXPECT_EQ(made.arc_of(3).centre, (Vec2{6, 24}));
  EXPECT_NEAR(made.arc_of(3).sweep_rad, -std::numbers::pi / 2, 1e-9);
}

TEST(AsProgrammed, WithoutCompensationNothingIsOtherwise) {
  test::FeaturePath path;
  go_round_rectangle(path);
  const Recording made = as_programmed(path.recording());
  for (std::uint32_t row = 0; row < made.count(); ++row)
    EXPECT_EQ(made.moves[row].to, path.recording().moves[row].to);
}

}  // namespace
}  // namespace kerf::features
