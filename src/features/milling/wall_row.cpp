#include "features/milling/wall_row.hpp"

#include <cmath>

#include "features/milling/tool_reach.hpp"

namespace kerf::features {

using contour::Edge;
using geometry::Vec2;

std::optional<WallRow> wall_row(const Recording& recording, std::uint32_t row) {
  if (row >= recording.count() || !recording.moves[row].cuts()) return std::nullopt;
  const auto tool = recording.tools.find(recording.state_of(recording.moves[row]).tool);
  if (tool == recording.tools.end() || is_conical(tool->second)) return std::nullopt;
  WallRow its{.number = row, .radius = reach_of(tool->second).radius};
  recording.append_edges(row, its.path);
  if (its.path.empty()) return std::nullopt;
  for (const Edge& edge : its.path) its.length += contour::length(edge);
  return its;
}

// Its ends no farther off than the tolerance.
bool is_beside(const WallRow& row, Vec2 point) {
  for (const Edge& edge : row.path) {
    if (std::fabs(contour::distance(edge, point) - row.radius) > kBeside_mm) continue;
    const double share = contour::nearest_share(edge, point);
    if (share > 0 && share < 1) return true;
    const Vec2 way =
        geometry::unit(share > 0 ? contour::tangent_at_end(edge) : contour::tangent_at_start(edge));
    const Vec2 arm = point - (share > 0 ? edge.to : edge.from);
    if (std::fabs(geometry::dot(way, arm)) <= kBeside_mm) return true;
  }
  return false;
}

bool is_beside(const WallRow& row, const Edge& edge) {
  return is_beside(row, edge.from) && is_beside(row, edge.to) &&
         is_beside(row, contour::point_at(edge, 0.5));
}

bool is_side_of(const WallRow& row, const Edge& edge) {
  const Edge& way = row.path.front();
  if ((edge.bulge == 0) != (way.bulge == 0)) return false;
  return edge.bulge == 0 ||
         geometry::length(contour::centre(edge) - contour::centre(way)) <= kBeside_mm;
}

}  // namespace kerf::features
