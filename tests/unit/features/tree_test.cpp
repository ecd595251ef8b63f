#include <gtest/gtest.h>

#include <numbers>

#include "features/tree/key.hpp"
#include "features/tree/normal_form.hpp"

namespace kerf::features {
namespace {

using contour::Contour;

TEST(Keys, AreTheChecksumOfZeroToolKindPlaceAndBottom) {
  Keys keys;
  EXPECT_EQ(keys.of("G54", 1, "R", {30, 24}, -4), "5b3956dc");
  EXPECT_EQ(keys.of("G54", 1, "R", {30, 24}, -4), "5b3956dc-2");
  EXPECT_NE(keys.of("G54", 1, "R", {30, 24.001}, -4), "5b3956dc");
}

TEST(NormalForm, BeginsAtTheLeastXAndGoesCounterclockwise) {
  const Contour clockwise{{{{4, 0}}, {{0, 0}}, {{0, 3}}, {{4, 3}}}, true};
  const Contour normal = normal_form(clockwise);
  ASSERT_EQ(normal.vertices.size(), 4U);
  EXPECT_EQ(normal.vertices[0].point, (contour::Vec2{0, 0}));
  EXPECT_EQ(normal.vertices[1].point, (contour::Vec2{4, 0}));
}

TEST(NormalForm, NeighboursOnOneLineAreOneEdge) {
  const Contour divided{{{{2, 0}}, {{4, 0}}, {{4, 3}}, {{0, 3}}, {{0, 0}}}, true};
  EXPECT_EQ(normal_form(divided).vertices.size(), 4U);
}

TEST(NormalForm, ACircleIsTwoHalvesFromItsLeftmostPoint) {
  const double quarter = 0.41421356237309503;
  const Contour circle{
      {{{8, 0}, quarter}, {{0, 8}, quarter}, {{-8, 0}, quarter}, {{0, -8}, quarter}}, true};
  const Contour normal = normal_form(circle);
  ASSERT_EQ(normal.vertices.size(), 2U);
  EXPECT_NEAR(normal.vertices[0].point.u, -8, 1e-9);
  EXPECT_NEAR(normal.vertices[1].point.u, 8, 1e-9);
  EXPECT_NEAR(contour::area(normal), 64 * std::numbers::pi, 1e-9);
}

TEST(NormalForm, NoArcTurnsByMoreThanHalfACircle) {
  // Three quarters of a circle of radius 5, closed by two lines through its middle.
  const double bulge = 1 + std::numbers::sqrt2;  // tangent of 270°/4
  const Contour cake{{{{5, 0}, bulge}, {{0, -5}}, {{0, 0}}}, true};
  const Contour normal = normal_form(cake);
  EXPECT_NEAR(contour::area(normal), 25 * std::numbers::pi * 3 / 4, 1e-9);
  EXPECT_EQ(normal.vertices.size(), 4U);
  for (const auto& vertex : normal.vertices) EXPECT_LE(vertex.bulge, 1 + 1e-9);
}

}  // namespace
}  // namespace kerf::features
