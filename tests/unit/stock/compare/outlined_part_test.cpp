// Parts that are outlines: turned about Z, and plates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/contour/boolean.hpp"
#include "math/math.hpp"
#include "stock/compare/comparison.hpp"
#include "stock/compare/mesh_solid.hpp"
#include "stock/compare/meshes.hpp"
#include "stock/compare/outlines.hpp"
#include "stock/compare/plate_solid.hpp"
#include "stock/compare/turned_solid.hpp"
#include "stock/dexel/lattice.hpp"

namespace kerf::stock::compare::test {
namespace {

using contour::Region;
using contour::Vec2;

constexpr Tolerance kTolerance{};

/// What the lines through a place say of it.
void expect_on_lines(const Solid& part, Vec3 place, bool is_in) {
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Stretch> material;
    part.inside(axis, dexel::on_axis(place, (axis + 1) % 3), dexel::on_axis(place, (axis + 2) % 3),
                material);
    const double at = dexel::on_axis(place, axis);
    const bool holds = std::any_of(material.begin(), material.end(), [&](const Stretch& one) {
      return one.low < at && at < one.high;
    });
    EXPECT_EQ(holds, is_in) << "along " << axis;
  }
}

/// A round bar of n sides around it, so that it is nowhere inside of the circle's chords.
TriangleMesh round(double radius, double low, double high, int n) {
  std::vector<std::array<double, 2>> outline;
  for (int i = 0; i < n; ++i) {
    const auto [sine, cosine] = math::sine_cosine(2 * std::numbers::pi * i / n);
    outline.push_back({radius * cosine, radius * sine});
  }
  return prism(outline, low, high);
}

/// A shaft of 40 with a seat of 30 to Z-20 that motion 7 has cut, its shoulder by motion 8.
Region shaft(double seat = 30) {
  Region region = rectangle({-60, 0}, {0, 20});
  return contour::subtract(
      region,
      contour::region_of(contour::Contour{
          {{{-20, seat / 2}, 0, 7}, {{10, seat / 2}, 0, 7}, {{10, 30}, 0, 7}, {{-20, 30}, 0, 8}}}));
}

TEST(TurnedSolid, DistancesAndStretchesAreThoseOfTheRevolvedRegion) {
  const Region region = shaft();
  const TurnedSolid part(region);
  Random random(21);
  Hint hint;
  for (int i = 0; i < 500; ++i) {
    const Vec3 place = random.in({-25, -25, -65}, {25, 25, 5});
    const double rho = std::hypot(place.x, place.y);
    const double to_bar = std::max({-60 - place.z, place.z - 0, rho - 20});
    const double to_seat = std::min(place.z + 20, rho - 15);  // > 0: in what was cut
    const bool is_in = to_bar < 0 && to_seat < 0;
    const Near near = part.near(place, hint);
    EXPECT_EQ(near.distance_mm < 0, is_in) << place.x << " " << place.y << " " << place.z;
    expect_on_lines(part, place, is_in);
  }
  EXPECT_NEAR(part.near({15.3, 0, -10}, hint).distance_mm, 0.3, 1e-12);
  EXPECT_EQ(part.near({15.3, 0, -10}, hint).motion, 7U);
  EXPECT_EQ(part.near({0, 18, -19.9}, hint).motion, 8U);
}

TEST(TurnedSolid, PointsStandForTheWholeSurface) {
  const Region region = shaft();
  const TurnedSolid part(region);
  double area = 0;
  for (std::size_t i = 0; i < part.rows(); ++i) {
    Part::Row row;
    part.row(i, row);
    for (const SurfacePoint& point : row.points) area += point.area_mm2;
  }
  const double wanted = std::numbers::pi * (2 * 20 * 20 + 2 * 20 * 40 + 2 * 15 * 20);
  EXPECT_NEAR(area, wanted, 1e-6 * wanted);
}

TEST(TurnedSolid, ASeatThatIsTooThinIsOneGougeOfItsFormulaAndItsMotion) {
  const Region region = shaft(29.6);
  const Region wanted = shaft(30);
  const TurnedSolid part(region);
  const Comparison one = compare(part, TurnedSolid(wanted), kTolerance, 1);
  EXPECT_EQ(one.of(Side::gouge).regions, 1U);
  EXPECT_EQ(one.of(Side::excess).regions, 0U);
  EXPECT_NEAR(one.of(Side::gouge).max_mm, 0.2, 1e-9);
  const double volume = std::numbers::pi * (15 * 15 - 14.8 * 14.8) * 20;
  EXPECT_NEAR(one.of(Side::gouge).volume_mm3, volume, 0.02 * volume);
  EXPECT_NEAR(one.of(Side::gouge).all_mm3, volume, 0.02 * volume);
  ASSERT_EQ(one.regions.front().motions.size(), 2U);
  EXPECT_EQ(one.regions.front().motions.front().motion, 7U);
  EXPECT_GT(one.regions.front().motions.front().share, 0.95);
}

TEST(TurnedSolid, AMeshOfManySidesIsItsDesign) {
  const Region region = rectangle({-15, 0}, {0, 10});
  const Comparison right =
      compare(TurnedSolid(region), MeshSolid(round(10, -15, 0, 256)), kTolerance, 1);
  EXPECT_EQ(right.of(Side::gouge).regions + right.of(Side::excess).regions, 0U);
  const Comparison wrong =
      compare(TurnedSolid(region), MeshSolid(round(9.8, -15, 0, 256)), kTolerance, 1);
  EXPECT_EQ(wrong.of(Side::excess).regions, 1U);
  EXPECT_NEAR(wrong.of(Side::excess).max_mm, 0.2 + 9.8 * (1 - std::cos(std::numbers::pi / 256)),
              1e-3);
  const double sides = 128 * 9.8 * 9.8 * std::sin(2 * std::numbers::pi / 256);
  const double volume = (std::numbers::pi * 100 - sides) * 15;
  EXPECT_NEAR(wrong.of(Side::excess).volume_mm3, volume, 0.01 * volume);
}

TEST(TurnedSolid, TheSamePartIsTheSameWhicheverWayItWasDivided) {
  const Region whole = shaft();
  const Region pieces = contour::unite(contour::intersect(whole, rectangle({-70, 0}, {-31.7, 40})),
                                       contour::intersect(whole, rectangle({-31.7, 0}, {10, 40})));
  const Comparison one = compare(TurnedSolid(pieces), TurnedSolid(whole), kTolerance, 2);
  for (const Side side : {Side::gouge, Side::excess}) {
    EXPECT_EQ(one.of(side).max_mm, 0);
    EXPECT_EQ(one.of(side).all_mm3, 0);
  }
}

TEST(PlateSolid, DistancesAndStretchesAreThoseOfThePlate) {
  const Region region = contour::subtract(rectangle({0, 0}, {30, 20}), contour::disc({15, 10}, 5));
  const PlateSolid part(region, {{0, 0, -3}, {30, 20, 0}});
  Random random(22);
  Hint hint;
  for (int i = 0; i < 500; ++i) {
    const Vec3 place = random.in({-5, -5, -6}, {35, 25, 3});
    const double rho = std::hypot(place.x - 15, place.y - 10);
    const double beside = std::max({-place.x, place.x - 30, -place.y, place.y - 20, 5 - rho});
    const double over = std::max(-3 - place.z, place.z);
    const Near near = part.near(place, hint);
    if (beside < 0 && over < 0) {
      EXPECT_NEAR(near.distance_mm, std::max(beside, over), 1e-9);
    } else {
      EXPECT_GT(near.distance_mm, 0);
    }
    expect_on_lines(part, place, beside < 0 && over < 0);
  }
}

TEST(PlateSolid, AHoleThatIsTooLargeIsAGougeOfItsRing) {
  const auto plate = [](double radius) {
    return contour::subtract(rectangle({0, 0}, {30, 20}), contour::disc({15, 10}, radius, 4));
  };
  const Region here = plate(5.1);
  const Region there = plate(5);
  const Bounds sheet{{0, 0, -3}, {30, 20, 0}};
  const Comparison one = compare(PlateSolid(here, sheet), PlateSolid(there, sheet), kTolerance, 1);
  EXPECT_EQ(one.of(Side::gouge).regions, 1U);
  EXPECT_EQ(one.of(Side::excess).regions, 0U);
  EXPECT_NEAR(one.of(Side::gouge).max_mm, 0.1, 1e-9);
  const double ring = std::numbers::pi * (5.1 * 5.1 - 25) * 3;
  EXPECT_NEAR(one.of(Side::gouge).volume_mm3, ring, 0.02 * ring);
  ASSERT_EQ(one.regions.front().motions.size(), 1U);
  EXPECT_EQ(one.regions.front().motions.front().motion, 4U);
}

TEST(PlateSolid, OfAPartThatIsNotThereAllIsMissingOnTheLinesOfItsSheet) {
  const Bounds sheet{{0, 0, -3}, {30, 20, 0}};
  const Region wanted = rectangle({10, 5}, {20, 15});
  const Comparison one = compare(PlateSolid({}, sheet), PlateSolid(wanted, sheet), kTolerance, 1);
  EXPECT_EQ(one.of(Side::gouge).regions, 1U);
  EXPECT_NEAR(one.of(Side::gouge).volume_mm3, 300, 3);
  EXPECT_EQ(one.of(Side::excess).regions, 0U);
}

}  // namespace
}  // namespace kerf::stock::compare::test
