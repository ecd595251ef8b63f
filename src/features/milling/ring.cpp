#include "features/milling/ring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "features/literal/left_inside.hpp"
#include "features/path/tolerance.hpp"
#include "features/tree/normal_form.hpp"
#include "geometry/contour/box_tree.hpp"
#include "geometry/contour/edit.hpp"
#include "geometry/contour/sweep.hpp"

namespace kerf::features {
namespace {

using contour::Box;
using contour::Contour;
using contour::Edge;

constexpr std::size_t kMostEdges = 20'000;
constexpr double kLeastPart = 1e-9;
constexpr double kLeastRound = 0.5;

/// Where two edges have a point in common, by their shares.
struct Meeting {
  double first = 0;
  double second = 0;
};

std::optional<Meeting> at_point(const Edge& a, const Edge& b, Vec2 point) {
  if (contour::distance(a, point) > kSamePoint_mm || contour::distance(b, point) > kSamePoint_mm)
    return std::nullopt;
  return Meeting{contour::nearest_share(a, point), contour::nearest_share(b, point)};
}

// Ends first, because edges that lie on each other cross nowhere.
std::optional<Meeting> meeting_of(const Edge& a, const Edge& b) {
  for (const Vec2 point : {a.from, a.to, b.from, b.to}) {
    if (const auto meeting = at_point(a, b, point)) return meeting;
  }
  const auto crossing = contour::meeting_point(a, b, contour::point_at(b, 0.5));
  return crossing ? at_point(a, b, *crossing) : std::nullopt;
}

std::vector<Edge> edges_of(const Contour& path) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < contour::edge_count(path); ++i)
    edges.push_back(contour::edge_of(path, i));
  return edges;
}

/// From the meeting on one edge to that on a later one.
Contour between(const std::vector<Edge>& edges, std::size_t i, std::size_t j, Meeting meeting) {
  Contour loop;
  for (std::size_t k = i; k <= j; ++k) {
    const double begin = k == i ? meeting.first : 0;
    const double end = k == j ? meeting.second : 1;
    if (end - begin < kLeastPart) continue;
    const Edge edge = contour::part(edges[k], begin, end);
    loop.vertices.push_back({edge.from, edge.bulge, edge.owner});
  }
  return loop;
}

/// The first way round that a path closes by coming back to itself, beside its vertices, too.
std::optional<Contour> closed_part(const std::vector<Edge>& edges) {
  if (edges.size() < 3 || edges.size() > kMostEdges) return std::nullopt;
  std::vector<Box> boxes;
  for (const Edge& edge : edges) boxes.push_back(contour::extents(edge).grown(kSamePoint_mm));
  const contour::BoxTree tree(boxes);
  for (std::size_t j = 2; j < edges.size(); ++j) {
    std::vector<std::size_t> earlier;
    tree.search(boxes[j], [&](std::uint32_t i) {
      if (i + 1 < j) earlier.push_back(i);
    });
    std::sort(earlier.begin(), earlier.end());
    for (const std::size_t i : earlier) {
      const auto meeting = meeting_of(edges[i], edges[j]);
      if (!meeting) continue;
      Contour loop = between(edges, i, j, *meeting);
      if (std::fabs(contour::area(loop)) > kEmptyArea_mm2) return loop;
    }
  }
  return std::nullopt;
}

std::optional<Contour> single_loop(const Recording& recording, const Level& level,
                                   const LoopsOfRows& loops) {
  if (loops.loops.size() > 1 || level.runs.size() != 1) return std::nullopt;
  if (loops.loops.size() == 1) return recording.contour_of(loops.loops.front().rows);
  return closed_part(edges_of(path_of(recording, level.runs.front())));
}

// What leads to a loop and away from it is shorter than that; more would clear something, too.
bool is_mostly_loop(const Recording& recording, const Level& level, const Contour& loop) {
  double all = 0;
  for (const std::uint32_t row : level.rows(recording)) all += recording.length_of(row);
  return all <= 2 * contour::length(loop);
}

// One island, of a loop that goes round it: it is shorter by the tool's own round. Lines that clear
// something and come back to where they began go there and back instead.
bool goes_round_island(const Ring& ring, double radius) {
  std::vector<double> lengths;
  for (const Contour& loop : ring.sweep.loops) {
    if (!contour::is_counterclockwise(loop) && !is_sliver(loop))
      lengths.push_back(contour::length(loop));
  }
  return lengths.size() == 1 && lengths.front() + 2 * std::numbers::pi * radius >=
                                    kLeastRound * contour::length(ring.loop);
}

// The first or last point of the rows that is not on the loop.
std::optional<Vec2> lead_beside(const Recording& recording, const Level& level,
                                const Contour& loop) {
  const Span rows = level.runs.front().rows;
  for (const Vec2 end : {recording.flat_from(rows.first), recording.flat_to(rows.last)}) {
    if (contour::distance(loop, end) > kSamePoint_mm) return end;
  }
  return std::nullopt;
}

Contour opened(Contour loop) {
  loop.is_closed = false;
  loop.vertices.push_back({loop.vertices.front().point, 0, loop.vertices.back().owner});
  return loop;
}

}  // namespace

std::optional<Ring> ring_of(const Recording& recording, const Level& level,
                            const LoopsOfRows& loops) {
  auto loop = single_loop(recording, level, loops);
  if (!loop || !is_mostly_loop(recording, level, *loop)) return std::nullopt;
  if (!is_left_inside(*loop, level.radius)) return std::nullopt;
  Ring ring{.loop = *loop, .sweep = contour::sweep_of_disc(opened(*loop), level.radius)};
  if (!goes_round_island(ring, level.radius)) return std::nullopt;
  ring.lead = lead_beside(recording, level, *loop);
  return ring;
}

}  // namespace kerf::features
