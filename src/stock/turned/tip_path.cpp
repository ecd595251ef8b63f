#include "stock/turned/tip_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/vec3.hpp"
#include "math/math.hpp"

namespace kerf::stock::turned {
namespace {

using contour::Edge;
using contour::Vec2;

// Off the plane by rounding alone.
constexpr double kOff_mm = 1e-6;
constexpr double kMostParts = 4096;

bool is_off(double y) { return std::fabs(y) > kOff_mm; }
Vec2 in_plane(Vec3 point) { return {point.z, point.x}; }

bool stays(const StraightWay& way) { return !is_off(way.from.y) && !is_off(way.to.y); }
bool stays(const ArcWay& way) {
  const double largest = std::max(std::fabs(way.radius), std::fabs(way.radius + way.radius_change));
  return !is_off(way.centre.y) && geometry::length(way.rise) <= kOff_mm &&
         !is_off(way.e1.y * largest) && !is_off(way.e2.y * largest);
}
bool stays(const TurningWay& /*way*/) { return false; }

std::vector<Edge> path(const StraightWay& way) { return {{in_plane(way.from), in_plane(way.to)}}; }

/// Between two places on the circles of a spiral there are (Δr Δφ) / 8n² from an arc to it.
double parts_of(const ArcWay& way) {
  const double turn = std::fabs(way.turn_rad);
  const double bent = std::sqrt(std::fabs(way.radius_change) * turn / (8 * kPathError_mm));
  const double halves = turn / (std::numbers::pi * (1 + 1e-9));
  return std::clamp(std::ceil(std::max(bent, halves)), 1.0, kMostParts);
}

std::vector<Edge> path(const ArcWay& way) {
  const double parts =
      std::fabs(way.radius_change) > kOff_mm / 1000
          ? parts_of(way)
          : std::max(1.0, std::ceil(std::fabs(way.turn_rad) / (std::numbers::pi * (1 + 1e-9))));
  // e1 and e2 may be a left-handed pair in the plane.
  const double sense = geometry::cross(in_plane(way.e1), in_plane(way.e2)) > 0 ? 1 : -1;
  const double bulge = math::tan(sense * way.turn_rad / (4 * parts));
  std::vector<Edge> edges;
  Vec2 from = in_plane(point_at(way, 0));
  for (double i = 1; i <= parts; ++i) {
    const Vec2 to = in_plane(point_at(way, i / parts));
    edges.push_back({from, to, bulge});
    from = to;
  }
  return edges;
}

std::vector<Edge> path(const TurningWay& way) { return path(StraightWay{way.from, way.to}); }

}  // namespace

bool is_in_plane(const Way& way) {
  return std::visit([](const auto& one) { return stays(one); }, way);
}

std::vector<Edge> tip_path(const Way& way) {
  return std::visit([](const auto& one) { return path(one); }, way);
}

}  // namespace kerf::stock::turned
