#include "features/rewrite/ruling.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace kerf;
using features::Interval;
using features::Ruling;

contour::Region region(const std::vector<contour::Vertex>& vertices) {
  return contour::region_of(contour::Contour{vertices, true});
}

// Arms to the right at the bottom and upwards at the left.
contour::Region ell() {
  return region({{{0, 0}}, {{60, 0}}, {{60, 20}}, {{20, 20}}, {{20, 50}}, {{0, 50}}});
}

void expect_part(const std::vector<Interval>& parts, double from, double to) {
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_NEAR(parts.front().from, from, 1e-9);
  EXPECT_NEAR(parts.front().to, to, 1e-9);
}

TEST(Ruling, LinesAlongABorderBelongToTheRegion) {
  const Ruling ruling;
  expect_part(features::parts_of_line(ell(), ruling, 0), 0, 60);
  expect_part(features::parts_of_line(ell(), ruling, 50), 0, 20);
  expect_part(features::parts_of_line(ell(), ruling, 20), 0, 60);
  expect_part(features::parts_of_line(ell(), ruling, 20.5), 0, 20);
  EXPECT_TRUE(features::parts_of_line(ell(), ruling, 50.5).empty());
}

TEST(Ruling, WhatStandsDividesALine) {
  const contour::Region square = region({{{0, 0}}, {{40, 0}}, {{40, 40}}, {{0, 40}}});
  contour::Region ring = square;
  ring.loops.push_back(contour::reversed(contour::disc({20, 20}, 5).loops.front()));
  const auto parts = features::parts_of_line(ring, Ruling{}, 23);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(parts[0].to, 16, 1e-9);
  EXPECT_NEAR(parts[1].from, 24, 1e-9);
}

TEST(Ruling, ATurnedRulingMeetsARoundBorder) {
  const double half = std::sqrt(0.5);
  const Ruling ruling{{half, half}, {-half, half}};
  const contour::Region disc = contour::disc({10, 10}, 13);
  const Interval lines = features::lines_across(disc, ruling);
  EXPECT_NEAR(lines.from, -13, 1e-9);
  EXPECT_NEAR(lines.to, 13, 1e-9);
  const double middle = 20 * half;
  expect_part(features::parts_of_line(disc, ruling, 5), middle - 12, middle + 12);
  expect_part(features::parts_of_line(disc, ruling, -5), middle - 12, middle + 12);
}

}  // namespace
