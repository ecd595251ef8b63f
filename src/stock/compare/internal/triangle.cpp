#include "stock/compare/internal/triangle.hpp"

#include <array>

namespace kerf::stock::compare {
namespace {

constexpr double square(Vec3 v) { return dot(v, v); }

OnTriangle nearest_on_edge(Vec3 from, Vec3 to, std::size_t number, Vec3 place) {
  const Vec3 way = to - from;
  const double whole = square(way);
  const double share = whole > 0 ? dot(place - from, way) / whole : 0;
  if (!(share > 0)) return {from, Feature(number)};
  if (share >= 1) return {to, Feature((number + 1) % 3)};
  return {from + share * way, Feature(number + 3)};
}

}  // namespace

// Where the foot of the plumb line is on the inner side of every edge, it is the point; else the
// nearest of the points of those edges that it is on the outer side of.
OnTriangle nearest_on(Vec3 a, Vec3 b, Vec3 c, Vec3 place) {
  const Vec3 normal = cross(b - a, c - a);
  const double area = square(normal);
  const std::array<Vec3, 3> corners{a, b, c};
  bool is_over = area > 0;
  OnTriangle best;
  double nearest = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 from = corners[i];
    const Vec3 to = corners[(i + 1) % 3];
    if (area > 0 && dot(cross(to - from, place - from), normal) >= 0) continue;
    is_over = false;
    const OnTriangle one = nearest_on_edge(from, to, i, place);
    const double far = square(place - one.point);
    if (nearest < 0 || far < nearest) {
      nearest = far;
      best = one;
    }
  }
  if (!is_over) return best;
  return {place - (dot(place - a, normal) / area) * normal, Feature::face};
}

}  // namespace kerf::stock::compare
