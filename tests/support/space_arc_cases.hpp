#pragma once

#include <array>
#include <cmath>
#include <string>

#include "geometry/vec3.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"

namespace kerf::test {

inline motion::AxisSetup five_axes() {
  motion::AxisSetup setup;
  for (const char letter : {'X', 'Y', 'Z', 'A', 'C'}) {
    motion::AxisConfig axis;
    axis.letter = letter;
    axis.rotary = letter == 'A' || letter == 'C';
    axis.rapid_per_min = 10'000;
    setup.axes.push_back(axis);
  }
  return setup;
}

/// Arcs worked by hand: where they start, pass and end (X Y Z A C), and their circle.
struct SpaceArcCase {
  const char* name;
  base::TipPoint from, via, to;
  geometry::Vec3 centre;
  double radius;
  geometry::Vec3 normal;
  double sweep_deg;

  [[nodiscard]] motion::SpaceArc arc(double feed_mm_min) const {
    return {.to = to, .via = via, .feed = {feed_mm_min}};
  }
  /// Through the same points and back to the first.
  [[nodiscard]] motion::SpaceArc circle(double feed_mm_min) const {
    return {.to = from, .via = via, .second_via = to, .feed = {feed_mm_min}, .full_circle = true};
  }
  /// How far a tip is from the whole circle.
  [[nodiscard]] double distance_mm(const base::TipPoint& tip) const {
    const geometry::Vec3 arm = geometry::Vec3{tip.values[0], tip.values[1], tip.values[2]} - centre;
    const double height = dot(arm, normal);
    return std::hypot(height, length(arm - height * normal) - radius);
  }
};

inline constexpr std::array<SpaceArcCase, 5> kSpaceArcs{{
    {"half circle",
     {{40, 0, 0, 0, 0}},
     {{0, 40, 0, 10, 45}},
     {{-40, 0, 0, 30, 90}},
     {0, 0, 0},
     40,
     {0, 0, 1},
     180},
    {"oblique",
     {{10, 0, 0, 5, 0}},
     {{0, 10, 5, 20, 30}},
     {{-6, -2, 12, -10, 50}},
     {1.793713, 0.090373, 5.906680},
     10.111388,
     {0.576215, 0.177297, 0.797836},
     192.646361},
    {"three quarters",
     {{10, 0, 0, 0, 0}},
     {{0, -10, 0, 15, -30}},
     {{0, 10, 0, 30, 60}},
     {0, 0, 0},
     10,
     {0, 0, -1},
     270},
    {"upright",
     {{0, 0, 0, 0, 0}},
     {{30, 0, 40, 20, -10}},
     {{60, 0, 0, 5, -40}},
     {30, 0, 8.75},
     31.25,
     {0, 1, 0},
     212.520409},
    {"from behind",
     {{50, 20, 10, 40, 170}},
     {{55, 25, 10, 35, 190}},
     {{60, 20, 10, 20, 200}},
     {55, 20, 10},
     5,
     {0, 0, -1},
     180},
}};

inline motion::Motion motion_of(const motion::Motion::Action& action) {
  motion::Motion motion;
  motion.action = action;
  return motion;
}

}  // namespace kerf::test
