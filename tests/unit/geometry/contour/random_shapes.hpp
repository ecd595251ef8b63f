#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/contour/region.hpp"
#include "seeded_random.hpp"

namespace kerf::contour::test {

using kerf::test::SeededRandom;

inline constexpr double kQuarterBulge = 0.41421356237309503;  // tan(90°/4)

/// A simple shape round a point: as many corners at random distances, some edges bulging a little.
inline Contour random_star(SeededRandom& random, Vec2 middle, double size, int corners) {
  Contour contour;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + random.in(0, 0.4)) / corners;
    const double reach = size * random.in(0.4, 1);
    const double bulge = random.coin() ? random.in(-0.25, 0.25) : 0;
    contour.vertices.push_back({middle + reach * Vec2{std::cos(angle), std::sin(angle)}, bulge, 0});
  }
  return contour;
}

/// Any closed contour: it crosses itself, on a coarse grid so that edges meet in their ends, lie on
/// each other, and have no length.
inline Contour random_tangle(SeededRandom& random, int corners) {
  constexpr double kBulges[] = {0, 0, 0, 0, 1, -1, kQuarterBulge, -kQuarterBulge};
  Contour contour;
  for (int i = 0; i < corners; ++i) {
    const Vec2 point{5.0 * random.count(-4, 4), 5.0 * random.count(-4, 4)};
    contour.vertices.push_back({point, kBulges[random.count(0, 7)], 0});
  }
  return contour;
}

/// Thin and long: two paths of `corners` each that keep a distance of 1e-7 to 1e-2 mm, turned
/// anyhow.
inline Contour random_sliver(SeededRandom& random, int corners) {
  const double width = random.size(1e-7, 1e-2);
  const double angle = random.in(0, 2 * std::numbers::pi);
  const Vec2 along{std::cos(angle), std::sin(angle)};
  const Vec2 across{-along.v, along.u};
  std::vector<Vec2> spine;
  for (int i = 0; i < corners; ++i)
    spine.push_back(random.in(2, 4) * i * along + random.in(-3, 3) * across);
  Contour contour;
  for (const Vec2 point : spine) contour.vertices.push_back({point, 0, 0});
  for (auto point = spine.rbegin(); point != spine.rend(); ++point)
    contour.vertices.push_back({*point + width * across, 0, 0});
  return contour;
}

/// Circles in a row, each touching the one before from outside or from inside.
inline std::vector<Contour> random_touching_discs(SeededRandom& random, int discs) {
  std::vector<Contour> contours;
  Vec2 centre{0, 0};
  double radius = random.in(1, 8);
  for (int i = 0; i < discs; ++i) {
    contours.push_back(disc(centre, radius).loops.front());
    const double next = random.in(1, 8);
    const double angle = random.in(0, 2 * std::numbers::pi);
    const double away = random.coin() ? radius + next : radius - next;
    centre = centre + away * Vec2{std::cos(angle), std::sin(angle)};
    radius = next;
  }
  return contours;
}

inline Contour mapped(Contour contour, double angle_rad, Vec2 shift) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  for (Vertex& vertex : contour.vertices) {
    const Vec2 p = vertex.point;
    vertex.point = Vec2{p.u * c - p.v * s, p.u * s + p.v * c} + shift;
  }
  return contour;
}

inline Contour mirrored(Contour contour) {
  for (Vertex& vertex : contour.vertices) {
    vertex.point.u = -vertex.point.u;
    vertex.bulge = -vertex.bulge;
  }
  return contour;
}

}  // namespace kerf::contour::test
