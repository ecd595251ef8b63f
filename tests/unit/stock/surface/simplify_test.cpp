// Fewer triangles: still closed, as many handles, near to what was.
#include "stock/surface/simplify.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/contour/boolean.hpp"
#include "soundness.hpp"
#include "stock/dexel/tri_dexel.hpp"
#include "stock/surface/contouring.hpp"
#include "stock/surface/dexel_samples.hpp"
#include "stock/surface/plate_surface.hpp"
#include "stock/surface/turned_surface.hpp"
#include "stock/turned/turned_part.hpp"

namespace kerf::stock::surface::test {
namespace {

constexpr double kPi = 3.141592653589793;

contour::Region square(double low, double high) {
  return {{{.vertices = {{{low, low}}, {{high, low}}, {{high, high}}, {{low, high}}}}}};
}

void expect_sound(const Surface& surface, long euler) {
  const Soundness found = soundness(surface);
  EXPECT_TRUE(found.is_sound()) << found.text();
  EXPECT_EQ(found.euler, euler) << found.text();
  EXPECT_EQ(surface.owners.size(), surface.mesh.triangles.size());
  EXPECT_EQ(surface.point_owners.size(), surface.mesh.points.size());
}

TEST(Simplified, ABoxOfDexelsBecomesTwelveTriangles) {
  const dexel::TriDexel box(dexel::box_shape({{0, 0, 0}, {20, 12, 8}}), 0.5, 1);
  const DexelSamples samples(box, 1);
  const Surface whole = Contouring(samples).surface(1);
  ASSERT_GT(whole.mesh.triangles.size(), 5000U);
  const Surface few = simplified(whole, 12);
  expect_sound(few, 2);
  EXPECT_EQ(few.mesh.triangles.size(), 12U);
  EXPECT_NEAR(soundness(few).volume_mm3, 20 * 12 * 8, 1e-3);
}

TEST(Simplified, ATurnedPartKeepsItsShapeWithATenthOfItsTriangles) {
  contour::Region part = turned::bar(50, -80, 0, 12);
  part = contour::subtract(part, contour::disc({-20, 25}, 6));
  const Surface whole = turned(part, 0.002);
  const double volume = soundness(whole).volume_mm3;
  for (const std::size_t share : {3U, 10U, 30U}) {
    const std::size_t most = whole.mesh.triangles.size() / share;
    const Surface few = simplified(whole, most);
    expect_sound(few, 0);
    EXPECT_LE(few.mesh.triangles.size(), most);
    EXPECT_GT(few.mesh.triangles.size(), most - 3);
    EXPECT_NEAR(soundness(few).volume_mm3, volume, 0.0005 * static_cast<double>(share) * volume)
        << share;
  }
}

TEST(Simplified, HolesStayHoles) {
  contour::Region sheet = square(0, 60);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      sheet = contour::subtract(sheet, contour::disc({10.0 + 20 * i, 10.0 + 20 * j}, 4));
    }
  }
  const Surface whole = plate(sheet, 0, 5, 0.0005);
  const Surface few = simplified(whole, 600);
  expect_sound(few, 2 - 2 * 9);
  EXPECT_LE(few.mesh.triangles.size(), 600U);
  const double formula = 5 * (3600 - 9 * kPi * 16);
  EXPECT_NEAR(soundness(few).volume_mm3, formula, 0.005 * formula);
}

// What hangs together cannot be less than a solid: there is an end, however few are asked for.
TEST(Simplified, AskedForNothingItKeepsEveryPieceAndHandle) {
  Surface whole = turned(turned::bar(40, -30, 0, 20), 0.01);
  expect_sound(simplified(whole, 1), 0);
  const contour::Region two = contour::unite(square(0, 10), square(20, 30));
  const Surface pieces = simplified(plate(two, 0, 5, 0.01), 1);
  EXPECT_EQ(soundness(pieces).shells, 2U);
  EXPECT_TRUE(soundness(pieces).is_sound());
}

TEST(Simplified, WhatHasNoMoreStaysAsItIs) {
  const Surface whole = plate(square(0, 10), 0, 5, 0.01);
  EXPECT_EQ(simplified(whole, 100).mesh.triangles, whole.mesh.triangles);
}

}  // namespace
}  // namespace kerf::stock::surface::test
