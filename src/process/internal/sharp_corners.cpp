#include "process/internal/sharp_corners.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/contour/edge.hpp"

namespace kerf::process {
namespace {

using contour::Contour;
using contour::Edge;
using geometry::Vec2;

constexpr double kSame_mm = 1e-7;

bool is_about_corner(const Edge& edge, const Contour& path, double half_kerf) {
  if (edge.bulge == 0 || std::abs(radius(edge) - half_kerf) > kSame_mm) return false;
  const Vec2 middle = centre(edge);
  return std::any_of(path.vertices.begin(), path.vertices.end(), [&](const auto& vertex) {
    return geometry::length(vertex.point - middle) <= kSame_mm;
  });
}

}  // namespace

Contour with_sharp_corners(const Contour& loop, const Contour& path, double kerf) {
  Contour sharp{{}, loop.is_closed};
  for (std::size_t i = 0; i < edge_count(loop); ++i) {
    const Edge edge = edge_of(loop, i);
    contour::Vertex from = loop.vertices[i];
    const double half = 0.5 * std::abs(sweep_rad(edge));
    const double reach = 0.5 * kerf / std::max(math::cos(half), 1e-9);
    if (!is_about_corner(edge, path, 0.5 * kerf) || reach > 2 * kerf) {
      sharp.vertices.push_back(from);
      continue;
    }
    from.bulge = 0;
    sharp.vertices.push_back(from);
    const Vec2 outwards = geometry::unit(point_at(edge, 0.5) - centre(edge));
    sharp.vertices.push_back({centre(edge) + reach * outwards, 0, from.owner});
  }
  return sharp;
}

}  // namespace kerf::process
