#include "geometry/contour/internal/loops.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/contour/tolerance.hpp"

namespace kerf::contour {
namespace {

using HalfEdge = PlanarMap::HalfEdge;

// The tangents of quarters of two angles make that of their sum.
double bulge_of_both(double a, double b) { return (a + b) / (1 - a * b); }

// Longer arcs would be known by their gap.
constexpr double kLargestBulge = 8;

// Follows the borders of what is taken. Where loops touch, it turns to the next border clockwise,
// so that what is inside stays whole on the left; a point that comes again ends a loop of its own.
class Tracer {
 public:
  Tracer(const PlanarMap& map, const std::vector<bool>& is_taken)
      : map_(map),
        is_taken_(is_taken),
        is_done_(map.half_edge_count(), false),
        place_(map.point_count(), ~0U) {}

  template <typename Take>
  void run(Take&& take) {
    for (HalfEdge h = 0; h < map_.half_edge_count(); ++h) {
      if (is_border(h) && !is_done_[h]) follow(h, take);
    }
  }

 private:
  bool is_border(HalfEdge h) const {
    return is_taken_[map_.face(h)] && !is_taken_[map_.face(PlanarMap::twin(h))];
  }

  HalfEdge next_border(HalfEdge h) const {
    HalfEdge next = map_.next(h);
    while (!is_border(next)) next = map_.clockwise_of(next);
    return next;
  }

  template <typename Take>
  void follow(HalfEdge first, Take& take) {
    path_.clear();
    HalfEdge h = first;
    do {
      is_done_[h] = true;
      path_.push_back(h);
      h = next_border(h);
    } while (h != first);
    split(take);
  }

  template <typename Take>
  void split(Take& take) {
    stack_.clear();
    for (const HalfEdge h : path_) {
      place_[map_.origin(h)] = static_cast<std::uint32_t>(stack_.size());
      stack_.push_back(h);
      const PointId end = map_.origin(PlanarMap::twin(h));
      const std::uint32_t place = place_[end];
      if (place >= stack_.size() || map_.origin(stack_[place]) != end) continue;
      take(std::span<const HalfEdge>(stack_).subspan(place));
      stack_.resize(place);
    }
  }

  const PlanarMap& map_;
  const std::vector<bool>& is_taken_;
  std::vector<bool> is_done_;
  std::vector<HalfEdge> path_;
  std::vector<HalfEdge> stack_;
  std::vector<std::uint32_t> place_;  ///< of the half-edge of the stack that leaves a point
};

double bulge_along(const PlanarMap& map, HalfEdge h) {
  const double bulge = map.pieces()[h / 2].bulge;
  return (h & 1U) == 0 ? bulge : -bulge;
}

Contour contour_of(const PlanarMap& map, std::span<const HalfEdge> loop) {
  Contour contour;
  contour.vertices.reserve(loop.size());
  for (const HalfEdge h : loop) {
    contour.vertices.push_back(
        {map.point(map.origin(h)), bulge_along(map, h), map.pieces()[h / 2].source});
  }
  return contour;
}

bool is_short_of_full(double bulge) { return bulge > 0 && bulge <= kLargestBulge; }

// Whether two edges in a row become one, and with which bulge.
bool join_parts(const Edge& first, const Edge& second, double& bulge) {
  if (first.owner != second.owner || (first.bulge == 0) != (second.bulge == 0)) return false;
  if (first.bulge == 0) return true;
  if (first.bulge * second.bulge < 0) return false;
  bulge = bulge_of_both(first.bulge, second.bulge);
  return is_short_of_full(std::copysign(1.0, first.bulge) * bulge);
}

// Far below the tolerance: what is joined comes again.
constexpr double kStraight_mm = 1e-11;

bool is_along(const Edge& edge, Vec2 point) { return distance(edge, point) <= kStraight_mm; }

// Whether both are parts of one edge from the beginning of the first to the end of the second.
bool go_on(const Edge& first, const Edge& second, double bulge) {
  const Vec2 end = tangent_at_end(first);
  const Vec2 start = tangent_at_start(second);
  const double product = geometry::length(end) * geometry::length(start);
  if (!(dot(end, start) > 0) || std::fabs(cross(end, start)) > 1e-2 * product) return false;
  const Edge both{first.from, second.to, bulge, first.owner};
  return is_along(both, first.to) && is_along(both, point_at(first, 0.5)) &&
         is_along(both, point_at(second, 0.5));
}

bool join_owned(const Edge& first, const Edge& second, double& bulge) {
  return join_parts(first, second, bulge) && go_on(first, second, bulge);
}

// Joins edges in a row as long as `joins` says so, beginning where it does not.
template <typename Joins>
void join(Contour& loop, Joins&& joins) {
  const std::size_t count = loop.vertices.size();
  if (count < 3) return;
  std::size_t begin = 0;
  double bulge = 0;
  while (begin < count &&
         joins(edge_of(loop, begin == 0 ? count - 1 : begin - 1), edge_of(loop, begin), bulge)) {
    ++begin;
  }
  std::vector<Vertex> kept;
  kept.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Edge edge = edge_of(loop, (begin + i) % count);
    bulge = 0;
    const bool is_joined =
        !kept.empty() &&
        joins({kept.back().point, edge.from, kept.back().bulge, kept.back().owner}, edge, bulge);
    if (is_joined) {
      kept.back().bulge = bulge;
    } else {
      kept.push_back({edge.from, edge.bulge, edge.owner});
    }
  }
  if (kept.size() > 1) loop.vertices = std::move(kept);
}

bool is_near(Vec2 a, Vec2 b) { return dot(a - b, a - b) <= kSame_mm * kSame_mm; }

// A strand that is there as a whole gets its own bulge back.
void restore(Contour& loop, std::span<const Strand> strands) {
  for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
    const Edge edge = edge_of(loop, i);
    if (edge.bulge == 0) continue;
    const Edge& whole = strands[edge.owner].edge;
    if (is_near(edge.from, whole.from) && is_near(edge.to, whole.to)) {
      loop.vertices[i].bulge = whole.bulge;
    } else if (is_near(edge.from, whole.to) && is_near(edge.to, whole.from)) {
      loop.vertices[i].bulge = -whole.bulge;
    }
  }
}

bool has_buried(const Contour& loop, std::span<const Strand> strands) {
  return std::any_of(loop.vertices.begin(), loop.vertices.end(),
                     [&](const Vertex& vertex) { return strands[vertex.owner].is_buried; });
}

}  // namespace

std::vector<Contour> joined_loops(const PlanarMap& map, const std::vector<bool>& is_taken,
                                  std::span<const Strand> strands) {
  std::vector<Contour> loops;
  Tracer(map, is_taken).run([&](std::span<const HalfEdge> path) {
    Contour loop = contour_of(map, path);
    if (std::fabs(area(loop)) < kNoArea_mm2 || has_buried(loop, strands)) return;
    join(loop, join_parts);
    restore(loop, strands);
    loops.push_back(std::move(loop));
  });
  return loops;
}

void give_owners(Contour& loop, std::span<const Strand> strands) {
  for (Vertex& vertex : loop.vertices) vertex.owner = strands[vertex.owner].edge.owner;
  join(loop, join_owned);
}

}  // namespace kerf::contour
