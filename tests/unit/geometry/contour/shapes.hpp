#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "geometry/contour/region.hpp"

namespace kerf::contour::test {

/// A closed contour of (x, y, bulge).
inline Contour closed(std::initializer_list<Vertex> vertices) { return {vertices, true}; }
inline Contour open(std::initializer_list<Vertex> vertices) { return {vertices, false}; }

inline Contour rectangle(double x0, double y0, double x1, double y1, std::uint32_t owner = 0) {
  return closed(
      {{{x0, y0}, 0, owner}, {{x1, y0}, 0, owner}, {{x1, y1}, 0, owner}, {{x0, y1}, 0, owner}});
}
inline Contour circle(Vec2 centre, double radius) { return disc(centre, radius).loops.front(); }

inline constexpr double kQuarter = 0.41421356237309503;  // tan(90°/4)

inline Contour rect40x30() { return rectangle(0, 0, 40, 30); }
inline Contour shape_l() {
  return closed({{{0, 0}}, {{60, 0}}, {{60, 20}}, {{20, 20}}, {{20, 50}}, {{0, 50}}});
}
inline Contour slot() { return closed({{{0, 0}}, {{40, 0}, 1}, {{40, 20}}, {{0, 20}, 1}}); }
inline Contour circle20() { return closed({{{-20, 0}, 1}, {{20, 0}, 1}}); }
inline Contour roundrect() {
  return closed({{{5, 0}},
                 {{55, 0}, kQuarter},
                 {{60, 5}},
                 {{60, 35}, kQuarter},
                 {{55, 40}},
                 {{5, 40}, kQuarter},
                 {{0, 35}},
                 {{0, 5}, kQuarter}});
}
inline Contour dumbbell() {
  return closed({{{0, 0}},
                 {{30, 0}},
                 {{30, 12}},
                 {{50, 12}},
                 {{50, 0}},
                 {{80, 0}},
                 {{80, 30}},
                 {{50, 30}},
                 {{50, 18}},
                 {{30, 18}},
                 {{30, 30}},
                 {{0, 30}}});
}

/// Areas and lengths of the loops, largest first.
inline std::vector<double> areas(const Region& region) {
  std::vector<double> result;
  for (const Contour& loop : region.loops) result.push_back(area(loop));
  std::sort(result.rbegin(), result.rend());
  return result;
}
inline std::vector<double> lengths(const Region& region) {
  std::vector<double> result;
  for (const Contour& loop : region.loops) result.push_back(length(loop));
  std::sort(result.rbegin(), result.rend());
  return result;
}

inline void expect_near(const std::vector<double>& actual, const std::vector<double>& expected,
                        double tolerance) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_NEAR(actual[i], expected[i], tolerance) << "of loop " << i;
  }
}

}  // namespace kerf::contour::test
