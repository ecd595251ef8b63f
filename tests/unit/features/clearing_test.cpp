// What loops leave of a pocket, by the rule of neighbouring loops and by sweeping all of them.
#include "features/rewrite/clearing.hpp"

#include <gtest/gtest.h>

#include <random>

#include "features/path/tolerance.hpp"
#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"
#include "geometry/contour/sweep.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Region;
using contour::Vec2;

double between(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A star-shaped polygon.
Contour polygon(std::mt19937& random, Vec2 centre, double low, double high) {
  const int count = std::uniform_int_distribution<int>(3, 9)(random);
  Contour made{{}, true};
  for (int i = 0; i < count; ++i) {
    const double angle = (i + between(random, -0.3, 0.3)) * 6.283185307179586 / count;
    const double reach = between(random, low, high);
    made.vertices.push_back({centre + Vec2{reach * std::cos(angle), reach * std::sin(angle)}});
  }
  return made;
}

/// Of any shape, with up to two islands.
Clearing random_clearing(std::mt19937& random, double radius) {
  Region region = contour::region_of(polygon(random, {}, 15, 40));
  const int islands = std::uniform_int_distribution<int>(0, 2)(random);
  for (int i = 0; i < islands; ++i) {
    const Vec2 centre{between(random, -12, 12), between(random, -12, 12)};
    region = contour::subtract(region, contour::region_of(polygon(random, centre, 2, 8)));
  }
  return {.region = region,
          .tool_radius = radius,
          .has_sharp_corners = std::bernoulli_distribution(0.5)(random)};
}

double left_by_sweeps(const Clearing& clearing, const std::vector<double>& distances) {
  Region rest = opened(clearing.region, clearing.tool_radius);
  for (const double distance : distances) {
    for (const Contour& loop : loops_at(clearing, distance))
      rest = contour::subtract(rest, contour::sweep_of_disc(loop, clearing.tool_radius));
  }
  return contour::area(contour::offset(rest, -kSamePoint_mm));
}

TEST(Clearing, SaysThatNothingIsLeftOnlyWhereSweepsLeaveNothing) {
  std::mt19937 random(11);
  int cleared = 0;
  for (int i = 0; i < 400; ++i) {
    const double radius = between(random, 1, 4);
    const Clearing clearing = random_clearing(random, radius);
    const double step = radius * between(random, 0.3, 1.9);
    const LoopDistances found = distances_of(clearing, {radius, radius + step}, step);
    if (found.from_wall.empty() || found.rest_mm2 > 0) continue;
    ++cleared;
    EXPECT_LE(left_by_sweeps(clearing, found.from_wall), kEmptyArea_mm2)
        << "clearing " << i << ", radius " << radius << ", step " << step;
  }
  EXPECT_GT(cleared, 300);
}

}  // namespace
}  // namespace kerf::features
