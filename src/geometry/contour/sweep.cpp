#include "geometry/contour/sweep.hpp"

#include <cmath>
#include <numbers>

#include "geometry/contour/internal/arrangement.hpp"
#include "geometry/contour/internal/chain.hpp"
#include "geometry/contour/tolerance.hpp"
#include "math/math.hpp"

namespace kerf::contour {
namespace {

bool is_passed(Winding w) { return w.first > 0; }

// Adds what a part of an edge sweeps that crosses `way` in one sense, as a loop counterclockwise.
void add_swept_part(std::vector<Strand>& strands, const Edge& edge, Vec2 way) {
  const Edge ahead{edge.from + way, edge.to + way, edge.bulge, edge.owner};
  std::vector<Edge> loop{edge,
                         {edge.to, ahead.to, 0, edge.owner},
                         reversed(ahead),
                         {ahead.from, edge.from, 0, edge.owner}};
  const bool is_forwards = cross(tangent_at_start(part(edge, 0.5, 1)), way) > 0;
  for (const Edge& each : loop) {
    strands.push_back({is_forwards ? each : reversed(each), Operand::first});
  }
}

// The edge is divided where it runs along `way`.
void add_swept_edge(std::vector<Strand>& strands, const Edge& edge, Vec2 way) {
  if (edge.bulge == 0) return add_swept_part(strands, edge, way);
  const Vec2 start = tangent_at_start(edge);
  const double sweep = sweep_rad(edge);
  const double sign = sweep > 0 ? 1 : -1;
  double turn = sign * math::atan2(cross(start, way), dot(start, way));
  while (turn <= 0) turn += std::numbers::pi;
  double share = 0;
  for (; turn < std::fabs(sweep); turn += std::numbers::pi) {
    const double next = turn / std::fabs(sweep);
    add_swept_part(strands, part(edge, share, next), way);
    share = next;
  }
  add_swept_part(strands, part(edge, share, 1), way);
}

}  // namespace

Region sweep_of_disc(const Contour& path, double radius) {
  if (!(radius > kSame_mm) || radius > kFarthest_mm || path.vertices.empty()) return {};
  const auto chains = chains_round(path);
  if (chains.empty() && is_sound(path)) {
    return disc(path.vertices.front().point, radius, path.vertices.front().owner);
  }
  std::vector<Strand> strands;
  for (const auto& chain : chains) add_raw_offset(strands, chain, radius);
  return {Arrangement(std::move(strands)).loops(is_passed)};
}

Region sweep_along(const Region& region, Vec2 way) {
  if (!(geometry::length(way) > kSame_mm) || geometry::length(way) > kFarthest_mm) return region;
  std::vector<Strand> strands;
  add_strands(strands, region.loops, Operand::first);
  for (const Contour& loop : region.loops) {
    for (std::size_t i = 0; i < edge_count(loop); ++i) {
      add_swept_edge(strands, edge_of(loop, i), way);
    }
  }
  return {Arrangement(std::move(strands)).loops(is_passed)};
}

}  // namespace kerf::contour
