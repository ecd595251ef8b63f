#include "geometry/contour/boolean.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "shapes.hpp"

namespace kerf::contour {
namespace {

using namespace test;  // NOLINT: shapes by their names

constexpr double kSixDecimals = 0.6e-6;

TEST(Boolean, OfTwoCirclesMeetsInTheirCommonPoints) {
  const Region a = disc({0, 0}, 10);
  const Region b = disc({12, 0}, 10);
  expect_near(areas(unite(a, b)), {538.859487}, kSixDecimals);
  expect_near(areas(intersect(a, b)), {89.459044}, kSixDecimals);
  expect_near(areas(subtract(a, b)), {224.700222}, kSixDecimals);
  expect_near(areas(symmetric_difference(a, b)), {224.700222, 224.700222}, kSixDecimals);
  const Region lens = intersect(a, b);
  for (const Vertex& vertex : lens.loops.front().vertices) {
    EXPECT_NEAR(std::fabs(vertex.point.v), vertex.point.v == 0 ? 0 : 8, 1e-9);
  }
}

TEST(Boolean, OfTwoRectangles) {
  const Region a = region_of(rect40x30());
  const Region b = region_of(rectangle(30, 10, 60, 20));
  expect_near(areas(unite(a, b)), {1400}, kSixDecimals);
  expect_near(areas(intersect(a, b)), {100}, kSixDecimals);
  expect_near(areas(subtract(a, b)), {1100}, kSixDecimals);
}

TEST(Boolean, ASharedBorderLeavesOneLoop) {
  const Region a = region_of(rect40x30());
  const Region b = region_of(rectangle(40, 0, 60, 30));
  const Region both = unite(a, b);
  expect_near(areas(both), {1800}, kSixDecimals);
  EXPECT_EQ(vertex_count(both), 4U);
  EXPECT_TRUE(intersect(a, b).is_empty());
  EXPECT_EQ(subtract(a, b), a);
}

TEST(Boolean, HolesAreLoopsOfTheirOwn) {
  const Region ring = subtract(disc({0, 0}, 20), disc({3, 0}, 10));
  expect_near(areas(ring), {1256.637061, -314.159265}, kSixDecimals);
  const Region island = unite(ring, disc({3, 0}, 4));
  ASSERT_EQ(island.loops.size(), 3U);
  std::vector<double> above;
  for (const auto& parent : parents(island))
    above.push_back(parent ? area(island.loops[*parent]) : 0);
  for (std::size_t i = 0; i < 3; ++i) {
    const double here = area(island.loops[i]);
    const double expected = here > 1000 ? 0 : here < 0 ? 1256.637061 : -314.159265;
    EXPECT_NEAR(above[i], expected, kSixDecimals) << "around the loop of area " << here;
  }
}

}  // namespace
}  // namespace kerf::contour
