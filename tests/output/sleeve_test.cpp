#include "output/picture/internal/sleeve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "plot_motions.hpp"

namespace kerf::output::plot {
namespace {

std::vector<Point3> simplified(const std::vector<Point3>& path, double tolerance) {
  Sleeve sleeve(tolerance);
  sleeve.start(knot(path.front(), 0));
  std::vector<Point3> kept{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (sleeve.add(knot(path[i], 0))) kept.push_back(place_of(sleeve.anchor()));
  }
  kept.push_back(place_of(sleeve.end()));
  return kept;
}

// Largest coordinate of the way from a point to a segment, by trying many places on the segment.
double distance(const Point3& p, const Point3& a, const Point3& b) {
  double best = 1e300;
  for (int i = 0; i <= 2000; ++i) {
    double furthest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      furthest = std::max(furthest, std::abs(a[k] + (b[k] - a[k]) * i / 2000 - p[k]));
    }
    best = std::min(best, furthest);
  }
  return best;
}

std::vector<Point3> wandering_path(std::uint32_t seed) {
  testing::Random random(seed);
  std::vector<Point3> path{{0, 0, 0}};
  Point3 way{1, 0, 0};
  for (int i = 0; i < 150; ++i) {
    Point3 next = path.back();
    for (std::size_t k = 0; k < 3; ++k) {
      way[k] += 0.7 * (random.next() - 0.5);
      next[k] += 0.2 * way[k];
    }
    path.push_back(next);
  }
  return path;
}

TEST(Sleeve, EveryPointLeftOutIsWithinTheToleranceOfThePointsKept) {
  constexpr double kTolerance = 0.3;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const auto path = wandering_path(seed);
    const auto kept = simplified(path, kTolerance);
    for (const Point3& point : path) {
      double best = 1e300;
      for (std::size_t i = 1; i < kept.size(); ++i) {
        best = std::min(best, distance(point, kept[i - 1], kept[i]));
      }
      EXPECT_LE(best, kTolerance + 0.01) << "seed " << seed;
    }
  }
}

TEST(Sleeve, KeepsOnlyTheEndsOfAStraightLine) {
  std::vector<Point3> path;
  for (int i = 0; i <= 1000; ++i) path.push_back({0.1 * i, -0.2 * i, 0.05 * i});
  EXPECT_EQ(simplified(path, 0.001), (std::vector<Point3>{path.front(), path.back()}));
}

TEST(Sleeve, KeepsCornersAndTurningPoints) {
  const std::vector<Point3> path{{0, 0, 0},   {5, 0, 0},  {10, 0, 0}, {10, 5, 0},
                                 {10, 10, 0}, {10, 4, 0}, {10, 0, 0}};
  EXPECT_EQ(simplified(path, 0.01),
            (std::vector<Point3>{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {10, 0, 0}}));
}

TEST(Sleeve, KeepsOnlyPointsOfThePath) {
  const auto path = wandering_path(5);
  for (const Point3& point : simplified(path, 0.2)) {
    EXPECT_NE(std::ranges::find(path, point), path.end());
  }
}

}  // namespace
}  // namespace kerf::output::plot
