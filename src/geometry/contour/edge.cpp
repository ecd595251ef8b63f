#include "geometry/contour/edge.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "math/math.hpp"

namespace kerf::contour {
namespace {

using geometry::cross;
using geometry::dot;
using geometry::left_of;

// `a` turned by the angle whose half has the tangent `t`, and made 1 + t² times as long.
Vec2 turned_by_half_tangent(Vec2 a, double t) { return (1 - t * t) * a + (2 * t) * left_of(a); }

Vec2 turned(Vec2 a, double angle_rad) {
  const auto [sine, cosine] = math::sine_cosine(angle_rad);
  return cosine * a + sine * left_of(a);
}

double on_line(const Edge& edge, Vec2 point) {
  const Vec2 chord = edge.to - edge.from;
  const double square = dot(chord, chord);
  if (square == 0) return 0;
  return std::clamp(dot(point - edge.from, chord) / square, 0.0, 1.0);
}

double on_arc(const Edge& edge, Vec2 point) {
  const Vec2 middle = centre(edge);
  const double sweep = sweep_rad(edge);
  const Vec2 arm = point - middle;
  // Counted from the middle of the arc, where the angle has no jump.
  const Vec2 apex = point_at(edge, 0.5) - middle;
  const double angle = math::atan2(cross(apex, arm), dot(apex, arm));
  return std::clamp(0.5 + angle / sweep, 0.0, 1.0);
}

int winding_of_line(Vec2 from, Vec2 to, Vec2 point) {
  if ((from.v <= point.v) == (to.v <= point.v)) return 0;
  const double side = cross(to - from, point - from);
  if (from.v <= point.v) return side > 0 ? 1 : 0;
  return side < 0 ? -1 : 0;
}

// Of the part of a circle between `from` and `to` that neither has its top nor its bottom inside.
int winding_of_flank(Vec2 from, Vec2 to, Vec2 point, Vec2 middle, double radius, bool is_right) {
  if ((from.v <= point.v) == (to.v <= point.v)) return 0;
  const double height = point.v - middle.v;
  const double half = std::sqrt(std::max(0.0, radius * radius - height * height));
  const double border = is_right ? middle.u + half : middle.u - half;
  if (point.u >= border) return 0;
  return from.v <= point.v ? 1 : -1;
}

struct Flanks {
  std::array<Vec2, 4> points;
  std::size_t count = 0;
};

// An arc divided at the top and bottom of its circle.
Flanks flanks_of(const Edge& edge, Vec2 middle, double r) {
  Flanks flanks{{edge.from}, 1};
  const double sweep = std::fabs(sweep_rad(edge));
  const double direction = edge.bulge > 0 ? 1 : -1;
  const Vec2 arm = edge.from - middle;
  constexpr double kFull = 2 * std::numbers::pi;
  double to_top = direction * math::atan2(arm.u, arm.v);  // the angle ahead to the top
  if (to_top < 0) to_top += kFull;
  const double to_bottom =
      to_top >= std::numbers::pi ? to_top - std::numbers::pi : to_top + std::numbers::pi;
  const Vec2 top = middle + Vec2{0, r};
  const Vec2 bottom = middle - Vec2{0, r};
  const bool top_first = to_top < to_bottom;
  if (std::min(to_top, to_bottom) < sweep) flanks.points[flanks.count++] = top_first ? top : bottom;
  if (std::max(to_top, to_bottom) < sweep) flanks.points[flanks.count++] = top_first ? bottom : top;
  flanks.points[flanks.count++] = edge.to;
  return flanks;
}

int winding_of_arc(const Edge& edge, Vec2 point) {
  const double r = radius(edge);
  const Vec2 middle = centre(edge);
  if (std::fabs(point.v - middle.v) > r) return winding_of_line(edge.from, edge.to, point);
  const Flanks flanks = flanks_of(edge, middle, r);
  int sum = 0;
  for (std::size_t i = 0; i + 1 < flanks.count; ++i) {
    const bool is_right = (flanks.points[i + 1].v > flanks.points[i].v) == (edge.bulge > 0);
    sum += winding_of_flank(flanks.points[i], flanks.points[i + 1], point, middle, r, is_right);
  }
  return sum;
}

}  // namespace

Vec2 centre(const Edge& edge) {
  const Vec2 chord = edge.to - edge.from;
  return 0.5 * (edge.from + edge.to) +
         ((1 - edge.bulge * edge.bulge) / (4 * edge.bulge)) * left_of(chord);
}

double radius(const Edge& edge) {
  return geometry::length(edge.to - edge.from) * (1 + edge.bulge * edge.bulge) /
         (4 * std::fabs(edge.bulge));
}

double sweep_rad(const Edge& edge) { return 4 * math::atan(edge.bulge); }

double length(const Edge& edge) {
  if (edge.bulge == 0) return geometry::length(edge.to - edge.from);
  return radius(edge) * std::fabs(sweep_rad(edge));
}

double area_about(const Edge& edge, Vec2 origin) {
  const double triangle = cross(edge.from - origin, edge.to - origin) / 2;
  if (edge.bulge == 0) return triangle;
  const Vec2 chord = edge.to - edge.from;
  const double b = edge.bulge;
  const double square = dot(chord, chord);
  // Of flat arcs the difference of angle and sine has no digits left: two thirds of the sagitta.
  if (std::fabs(b) < 1e-3) return triangle + square * b * (1 + 0.2 * b * b) / 3;
  const double r = radius(edge);
  const double sine = 4 * b * (1 - b * b) / ((1 + b * b) * (1 + b * b));
  return triangle + r * r * (sweep_rad(edge) - sine) / 2;
}

Box extents(const Edge& edge) {
  Box box;
  box.take(edge.from);
  box.take(edge.to);
  if (edge.bulge == 0) return box;
  const Vec2 middle = centre(edge);
  const double r = radius(edge);
  for (const Vec2 way : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
    const double share = on_arc(edge, middle + r * way);
    if (share > 0 && share < 1) box.take(middle + r * way);
  }
  return box;
}

Vec2 point_at(const Edge& edge, double share) {
  if (share <= 0) return edge.from;
  if (share >= 1) return edge.to;
  const Vec2 chord = edge.to - edge.from;
  if (edge.bulge == 0) return edge.from + share * chord;
  const double half = sweep_rad(edge) / 2;
  const double reach = math::sin(share * half) / math::sin(half);
  return edge.from + reach * turned(chord, (share - 1) * half);
}

Edge part(const Edge& edge, double first, double second) {
  const double bulge = edge.bulge == 0 || (first <= 0 && second >= 1)
                           ? edge.bulge
                           : math::tan((second - first) * sweep_rad(edge) / 4);
  return {point_at(edge, first), point_at(edge, second), bulge, edge.owner};
}

Edge reversed(const Edge& edge) { return {edge.to, edge.from, -edge.bulge, edge.owner}; }

Vec2 tangent_at_start(const Edge& edge) {
  const double b = edge.bulge;
  return (1 / (1 + b * b)) * turned_by_half_tangent(edge.to - edge.from, -b);
}

Vec2 tangent_at_end(const Edge& edge) {
  const double b = edge.bulge;
  return (1 / (1 + b * b)) * turned_by_half_tangent(edge.to - edge.from, b);
}

double nearest_share(const Edge& edge, Vec2 point) {
  return edge.bulge == 0 ? on_line(edge, point) : on_arc(edge, point);
}

double distance(const Edge& edge, Vec2 point) {
  if (edge.bulge == 0) return geometry::length(point - point_at(edge, on_line(edge, point)));
  const double share = on_arc(edge, point);
  if (share > 0 && share < 1) {
    return std::fabs(geometry::length(point - centre(edge)) - radius(edge));
  }
  return std::min(geometry::length(point - edge.from), geometry::length(point - edge.to));
}

int winding(const Edge& edge, Vec2 point) {
  if (edge.bulge == 0) return winding_of_line(edge.from, edge.to, point);
  return winding_of_arc(edge, point);
}

}  // namespace kerf::contour
