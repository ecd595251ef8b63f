#include "outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace kerf::parts {
namespace {

using contour::Vertex;

Vec2 along(Vec2 from, Vec2 to) { return geometry::unit(to - from); }

Vec2 meeting(Vec2 p, Vec2 u, Vec2 q, Vec2 v) {
  const double t = geometry::cross(q - p, v) / geometry::cross(u, v);
  return p + t * u;
}

/// The sides of a polygon, each moved to its left by a distance.
struct Side {
  Vec2 at;
  Vec2 way;
};

std::vector<Side> sides_of(const std::vector<Vec2>& corners, double distance) {
  std::vector<Side> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 way = along(corners[i], corners[(i + 1) % corners.size()]);
    sides.push_back({corners[i] + distance * geometry::left_of(way), way});
  }
  return sides;
}

bool is_convex(const std::vector<Vec2>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 a = corners[i];
    const Vec2 b = corners[(i + 1) % corners.size()];
    const Vec2 c = corners[(i + 2) % corners.size()];
    if (geometry::cross(b - a, c - b) < 0) return false;
  }
  return true;
}

// What of a convex polygon lies to the left of a line.
std::vector<Vec2> cut_by(const std::vector<Vec2>& polygon, const Side& side) {
  std::vector<Vec2> left;
  const auto height = [&](Vec2 p) { return geometry::cross(side.way, p - side.at); };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i];
    const Vec2 b = polygon[(i + 1) % polygon.size()];
    const double ha = height(a);
    const double hb = height(b);
    if (ha >= 0) left.push_back(a);
    if ((ha < 0) != (hb < 0)) left.push_back(a + (ha / (ha - hb)) * (b - a));
  }
  return left;
}

std::vector<Vec2> without_doubles(std::vector<Vec2> corners) {
  const auto end = std::unique(corners.begin(), corners.end(),
                               [](Vec2 a, Vec2 b) { return geometry::length(a - b) < 1e-2; });
  corners.erase(end, corners.end());
  while (corners.size() > 1 && geometry::length(corners.front() - corners.back()) < 1e-2)
    corners.pop_back();
  return corners;
}

double area_of(const std::vector<Vec2>& corners) {
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    twice += geometry::cross(corners[i], corners[(i + 1) % corners.size()]);
  return twice / 2;
}

// Sides move; of what is not convex each corner as long as none of its sides turns round.
std::vector<Vec2> moved_in(const std::vector<Vec2>& corners, double distance) {
  const std::vector<Side> sides = sides_of(corners, distance);
  std::vector<Vec2> moved = corners;
  if (is_convex(corners)) {
    for (const Side& side : sides) moved = cut_by(moved, side);
  } else {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Side& before = sides[(i + corners.size() - 1) % corners.size()];
      moved[i] = meeting(before.at, before.way, sides[i].at, sides[i].way);
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 way = moved[(i + 1) % corners.size()] - moved[i];
      if (geometry::dot(way, sides[i].way) <= 0) return {};
    }
  }
  moved = without_doubles(moved);
  return moved.size() < 3 || area_of(moved) < 1e-2 ? std::vector<Vec2>{} : moved;
}

// Corners that turn left become arcs that touch both sides.
Contour rounded(const std::vector<Vec2>& corners, double radius) {
  Contour contour;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 corner = corners[i];
    const Vec2 u = along(corners[(i + corners.size() - 1) % corners.size()], corner);
    const Vec2 v = along(corner, corners[(i + 1) % corners.size()]);
    const double turn = std::atan2(geometry::cross(u, v), geometry::dot(u, v));
    if (turn <= 0 || radius <= 0) {
      contour.vertices.push_back({corner});
      continue;
    }
    const double back = radius * std::tan(turn / 2);
    contour.vertices.push_back({corner - back * u, std::tan(turn / 4)});
    contour.vertices.push_back({corner + back * v});
  }
  return contour;
}

Contour stadium_at(Vec2 a, Vec2 b, double radius) {
  if (radius <= 0) return {};
  if (a == b) return {{{a - Vec2{radius, 0}, 1}, {a + Vec2{radius, 0}, 1}}, true};
  const Vec2 out = radius * geometry::left_of(along(a, b));
  return {{{a - out}, {b - out, 1}, {b + out}, {a + out, 1}}, true};
}

}  // namespace

Outline Outline::polygon(std::vector<Vec2> corners, double corner) {
  Outline outline;
  outline.corners_ = std::move(corners);
  outline.corner_ = corner;
  return outline;
}

Outline Outline::stadium(Vec2 a, Vec2 b, double radius) {
  Outline outline;
  outline.a_ = a;
  outline.b_ = b;
  outline.radius_ = radius;
  return outline;
}

Outline Outline::rectangle(Vec2 middle, Vec2 half, double angle_rad, double corner) {
  const Vec2 u{std::cos(angle_rad), std::sin(angle_rad)};
  const Vec2 v = geometry::left_of(u);
  return polygon({middle - half.u * u - half.v * v, middle + half.u * u - half.v * v,
                  middle + half.u * u + half.v * v, middle - half.u * u + half.v * v},
                 corner);
}

Vec2 Outline::middle() const {
  if (corners_.empty()) return 0.5 * (a_ + b_);
  Vec2 sum{};
  for (const Vec2 corner : corners_) sum = sum + corner;
  return (1.0 / static_cast<double>(corners_.size())) * sum;
}

double Outline::inner_radius() const {
  if (corners_.empty()) return radius_;
  double low = 0;
  double high = 1e3;
  for (int i = 0; i < 60; ++i) {
    const double half = (low + high) / 2;
    (moved_in(corners_, half).empty() ? high : low) = half;
  }
  return low;
}

Contour Outline::drawn() const {
  return corners_.empty() ? stadium_at(a_, b_, radius_) : rounded(corners_, corner_);
}

Contour Outline::milled(double radius) const {
  return corners_.empty() ? drawn() : rounded(corners_, std::max(corner_, radius));
}

Contour Outline::inset(double distance) const {
  if (corners_.empty()) return stadium_at(a_, b_, radius_ - distance);
  const std::vector<Vec2> moved = moved_in(corners_, distance);
  if (moved.empty()) return {};
  return rounded(moved, moved.size() == corners_.size() ? corner_ - distance : 0);
}

Contour Outline::outset(double distance) const {
  if (corners_.empty()) return stadium_at(a_, b_, radius_ + distance);
  Contour contour;
  const std::vector<Side> sides = sides_of(corners_, -distance);
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Side& before = sides[(i + corners_.size() - 1) % corners_.size()];
    const double turn = std::atan2(geometry::cross(before.way, sides[i].way),
                                   geometry::dot(before.way, sides[i].way));
    const Vec2 out = -distance * geometry::left_of(before.way);
    contour.vertices.push_back({corners_[i] + out, std::tan(turn / 4)});
    contour.vertices.push_back({sides[i].at});
  }
  return contour;
}

}  // namespace kerf::parts
