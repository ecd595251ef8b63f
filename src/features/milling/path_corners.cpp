#include "features/milling/path_corners.hpp"

#include <cmath>

namespace kerf::features {
namespace {

using contour::Edge;
using geometry::Vec2;

constexpr double kTurn = 0.0175;  // sine of a degree

}  // namespace

PathCorners::PathCorners(const Recording& recording, const std::vector<std::uint32_t>& rows) {
  std::vector<Edge> edges;
  for (const std::uint32_t row : rows) recording.append_edges(row, edges);
  for (const Edge& edge : edges) {
    add(edge.from, geometry::unit(contour::tangent_at_start(edge)));
    add(edge.to, -geometry::unit(contour::tangent_at_end(edge)));
  }
}

// Rays at one point are a list, the last one first.
void PathCorners::add(Vec2 at, Vec2 direction) {
  const auto known = index_.near(at);
  const std::int64_t next = known ? static_cast<std::int64_t>(*known) : -1;
  rays_.push_back({direction, next});
  index_.add(at, static_cast<std::uint32_t>(rays_.size() - 1));
}

bool PathCorners::is_corner(Vec2 at) const {
  const auto known = index_.near(at);
  if (!known) return false;
  const Ray& last = rays_[*known];
  for (std::int64_t i = static_cast<std::int64_t>(*known); i >= 0;
       i = rays_[static_cast<std::size_t>(i)].next) {
    const Ray& ray = rays_[static_cast<std::size_t>(i)];
    if (std::fabs(geometry::cross(ray.direction, last.direction)) > kTurn) return true;
  }
  return false;
}

}  // namespace kerf::features
