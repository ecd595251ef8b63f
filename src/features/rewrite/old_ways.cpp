#include "features/rewrite/old_ways.hpp"

#include <algorithm>

#include "features/path/tolerance.hpp"
#include "features/rewrite/wall_index.hpp"
#include "features/tree/normal_form.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;
using contour::Vec2;

constexpr double kAnyDistance_mm = 1e9;

double distance_to(const WallIndex& wall, const Contour& path) {
  double least = wall.distance(path.vertices.front().point, kAnyDistance_mm);
  for (std::size_t i = 0; i < contour::edge_count(path); ++i) {
    const Edge edge = contour::edge_of(path, i);
    least = wall.distance(contour::point_at(edge, 0.5), wall.distance(edge.from, least));
  }
  return least;
}

bool is_vertex(const Contour& contour, Vec2 point) {
  return std::any_of(contour.vertices.begin(), contour.vertices.end(), [&](const auto& vertex) {
    return geometry::length(vertex.point - point) <= kSamePoint_mm;
  });
}

/// How often a way turned sharply about what stands out of a wall, and how often round it.
struct Turns {
  int sharp = 0;
  int round = 0;
};

void count_turns(const OldLoop& loop, const WallIndex& wall, Turns& turns) {
  const double beside = loop.distance + kSamePoint_mm;
  for (std::size_t i = 0; i < loop.path.vertices.size(); ++i) {
    const contour::Edge edge = contour::edge_of(loop.path, i);
    if (edge.bulge != 0) {
      wall.vertices_near(contour::centre(edge), kSamePoint_mm, [&](double) { ++turns.round; });
    }
    if (wall.distance(edge.from, 2 * beside) <= beside) continue;
    wall.vertices_near(edge.from, 2.5 * loop.distance, [&](double off) {
      if (off > beside && off < 2.5 * loop.distance) ++turns.sharp;
    });
  }
}

/// Whether the old ways turned sharply round what stands out of the wall.
bool turned_sharply(const std::vector<OldLoop>& loops, const std::vector<Contour>& walls) {
  Turns turns;
  for (const Contour& wall : walls) {
    const WallIndex index(wall);
    for (const OldLoop& loop : loops) count_turns(loop, index, turns);
  }
  return turns.sharp > turns.round;
}

}  // namespace

std::vector<OldLoop> old_loops(const Recording& recording, const std::vector<Span>& loops,
                               const std::vector<Contour>& walls) {
  const std::vector<WallIndex> indices(walls.begin(), walls.end());
  std::vector<OldLoop> found;
  for (const Span& rows : loops) {
    OldLoop loop{.rows = rows, .path = recording.contour_of(rows), .distance = kAnyDistance_mm};
    for (const WallIndex& wall : indices)
      loop.distance = std::min(loop.distance, distance_to(wall, loop.path));
    loop.begins_at_corner = is_vertex(normal_form(loop.path), loop.path.vertices.front().point);
    found.push_back(std::move(loop));
  }
  return found;
}

const OldWay& OldWays::of(const Layer& layer) {
  const std::uint32_t first = layer.visits.front().first;
  const auto known = known_.find(first);
  if (known != known_.end()) return known->second;
  std::vector<Contour> walls{layer.nominal};
  walls.insert(walls.end(), layer.nominal_islands.begin(), layer.nominal_islands.end());
  std::vector<Span> spans;
  for (const Loop& loop : layer.loops) spans.push_back(loop.rows);
  OldWay way{.loops = old_loops(recording_, spans, walls)};
  way.turns_sharply = turned_sharply(way.loops, walls);
  return known_.emplace(first, std::move(way)).first->second;
}

}  // namespace kerf::features
