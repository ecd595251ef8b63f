#include "stock/compare/outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/contour/boolean.hpp"
#include "stock/compare/meshes.hpp"
#include "stock/compare/outlines.hpp"

namespace kerf::stock::compare::test {
namespace {

using contour::Region;
using contour::Vec2;

/// Rectangles and discs, some of them taken away.
Region random_region(Random& random) {
  Region region = rectangle({0, 0}, {20, 12});
  for (int i = 0; i < 8; ++i) {
    const Vec2 at{random.in(-2, 22), random.in(-2, 14)};
    const Vec2 size{random.in(0.5, 6), random.in(0.5, 6)};
    const bool is_disc = random.in(0, 1) < 0.6;
    const Region other = is_disc ? contour::disc(at, size.u, 9) : rectangle(at, at + size, 8);
    region =
        random.in(0, 1) < 0.6 ? contour::subtract(region, other) : contour::unite(region, other);
  }
  return region;
}

TEST(Outline, IsAsFarAndOnTheSideThatTheRegionSays) {
  Random random(11);
  for (int part = 0; part < 40; ++part) {
    const Region region = random_region(random);
    const Outline outline(region, Outline::OnAxis::is_surface);
    Hint hint;
    for (int i = 0; i < 200; ++i) {
      const Vec2 place{random.in(-4, 24), random.in(-4, 16)};
      const double wanted = contour::distance_to_border(region, place);
      if (wanted < 1e-9) continue;
      const bool is_in = contour::side_of(region, place, 0) == contour::Side::inside;
      EXPECT_NEAR(outline.near(place, hint).distance_mm, is_in ? -wanted : wanted, 1e-9);
      EXPECT_EQ(outline.holds(place), is_in);
    }
  }
}

TEST(Outline, LinesThroughItEnterAndLeaveWhereItsSidesChange) {
  Random random(12);
  for (int part = 0; part < 40; ++part) {
    const Region region = random_region(random);
    const Outline outline(region, Outline::OnAxis::is_surface);
    for (int i = 0; i < 40; ++i) {
      const bool is_u = i % 2 == 0;
      // Through corners, too.
      const Vec2 corner =
          region.loops.front()
              .vertices[static_cast<std::size_t>(i) % region.loops.front().vertices.size()]
              .point;
      const double at = i < 10 ? (is_u ? corner.v : corner.u) : random.in(0, 12);
      std::vector<Stretch> found;
      is_u ? outline.along_u(at, found) : outline.along_v(at, found);
      double last = -1e9;
      for (const Stretch& one : found) {
        EXPECT_LE(last, one.low);
        EXPECT_LT(one.low, one.high);
        last = one.high;
        for (const double end : {one.low, one.high}) {
          const Vec2 place = is_u ? Vec2{end, at} : Vec2{at, end};
          EXPECT_NEAR(contour::distance_to_border(region, place), 0, 1e-7);
        }
        const double middle = (one.low + one.high) / 2;
        const Vec2 inside = is_u ? Vec2{middle, at} : Vec2{at, middle};
        EXPECT_NE(contour::side_of(region, inside, 1e-9), contour::Side::outside);
      }
    }
  }
}

TEST(Outline, WhatLiesOnTheAxisIsNoSurface) {
  const Region region = rectangle({0, 0}, {20, 10}, 3);
  const Outline outline(region, Outline::OnAxis::is_none);
  Hint hint;
  EXPECT_NEAR(outline.near({10, 1}, hint).distance_mm, -9, 1e-12);
  EXPECT_EQ(outline.near({10, 1}, hint).motion, 3U);
  std::vector<Stretch> found;
  outline.along_v(10, found);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].low, 0);
  EXPECT_EQ(found[0].high, 10);
}

TEST(Outline, SamplesStandForAllOfTheBorderAndLookOutwards) {
  const Region region = contour::subtract(contour::disc({0, 0}, 5), contour::disc({1, 0}, 2));
  const Outline outline(region, Outline::OnAxis::is_surface);
  double length = 0;
  for (const Outline::Sample& sample : outline.samples(0.1)) {
    length += sample.mm;
    EXPECT_LE(sample.mm, 0.1);
    const bool is_hole = std::hypot(sample.at.u - 1, sample.at.v) < 2.1;
    const Vec2 arm = is_hole ? Vec2{1, 0} - sample.at : sample.at;
    EXPECT_NEAR(dot(geometry::unit(arm), sample.normal), 1, 1e-6);
  }
  EXPECT_NEAR(length, 2 * std::numbers::pi * 7, 1e-9);
}

}  // namespace
}  // namespace kerf::stock::compare::test
