#include "drawing/round_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kerf::drawing {
namespace {

using contour::Edge;

constexpr double kWhole_rad = 2 * std::numbers::pi;

std::vector<Edge> edges_round(const std::vector<contour::Vertex>& vertices) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    edges.push_back(
        {vertices[i].point, vertices[(i + 1) % vertices.size()].point, vertices[i].bulge});
  }
  return edges;
}

/// Whether arcs alone go round once in all, the same way.
bool goes_round(const std::vector<Edge>& edges) {
  constexpr double kNearly_rad = 0.05;
  double turn = 0;
  for (const Edge& edge : edges) {
    if (edge.bulge == 0 || (edge.bulge > 0) != (edges.front().bulge > 0)) return false;
    turn += sweep_rad(edge);
  }
  return std::abs(std::abs(turn) - kWhole_rad) <= kNearly_rad;
}

double off(Vec2 point, const Round& round) {
  return std::abs(geometry::length(point - round.centre) - round.radius);
}

/// How far an arc is from a circle at most: at its ends, or where it is nearest to the centre or
/// farthest from it.
double distance_from(const Round& round, const Edge& arc) {
  double most = std::max(off(arc.from, round), off(arc.to, round));
  const Vec2 middle = centre(arc);
  const Vec2 across = middle - round.centre;
  const double shift = geometry::length(across);
  if (shift == 0) return most;
  const Vec2 out = (radius(arc) / shift) * across;
  constexpr double kOnIt_mm = 1e-9;
  for (const Vec2 place : {middle + out, middle - out})
    if (distance(arc, place) <= kOnIt_mm) most = std::max(most, off(place, round));
  return most;
}

/// Of the cubics, where all of the path was some, else of the arcs that stand for its curves.
Round with_error(Round round, const std::vector<Edge>& edges, const Curves& curves) {
  const bool has_cubics = !curves.cubics.empty() && curves.count == curves.cubics.size();
  if (has_cubics)
    for (const auto& cubic : curves.cubics)
      round.error = std::max(round.error, distance_bound(cubic, round.centre, round.radius));
  else
    for (const Edge& edge : edges)
      round.error = std::max(round.error, curves.error + distance_from(round, edge));
  return round;
}

Round of_longest(const std::vector<Edge>& edges) {
  const auto longest = std::max_element(
      edges.begin(), edges.end(),
      [](const Edge& a, const Edge& b) { return std::abs(sweep_rad(a)) < std::abs(sweep_rad(b)); });
  return {centre(*longest), radius(*longest), 0};
}

/// The circle of least |d² - r²|, squared and summed up (I. Kasa, "A circle fitting procedure and
/// its error analysis", IEEE Trans. Instrum. Meas. 25, 1976): two linear equations about the
/// middle of the places.
std::optional<Round> through(const std::vector<std::array<Vec2, 4>>& places) {
  const double share = 1.0 / static_cast<double>(places.size());
  Vec2 middle;
  for (const auto& place : places) middle = middle + share * place.front();
  double uu = 0;
  double uv = 0;
  double vv = 0;
  double square = 0;
  Vec2 pull;
  for (const auto& place : places) {
    const Vec2 way = place.front() - middle;
    const double length = dot(way, way);
    uu += way.u * way.u;
    uv += way.u * way.v;
    vv += way.v * way.v;
    pull = pull + length * way;
    square += share * length;
  }
  const double area = uu * vv - uv * uv;
  if (!(area > 1e-9 * (uu + vv) * (uu + vv))) return std::nullopt;
  const Vec2 to_centre{0.5 * (pull.u * vv - pull.v * uv) / area,
                       0.5 * (pull.v * uu - pull.u * uv) / area};
  return Round{middle + to_centre, std::sqrt(square + dot(to_centre, to_centre)), 0};
}

constexpr std::size_t kMostEdges = 64;

}  // namespace

void Curves::take(const std::array<Vec2, 4>& cubic) {
  if (cubics.size() == count && count < kMostEdges) cubics.push_back(cubic);
  ++count;
}

void Curves::clear() {
  all = true;
  error = 0;
  cubics.clear();
  count = 0;
}

std::optional<Round> round_path(const std::vector<contour::Vertex>& vertices, const Curves& curves,
                                double most) {
  if (vertices.size() < 2 || vertices.size() > kMostEdges || !curves.all) return std::nullopt;
  const std::vector<Edge> edges = edges_round(vertices);
  if (!goes_round(edges)) return std::nullopt;
  Round best = with_error(of_longest(edges), edges, curves);
  if (curves.cubics.size() > 2)
    if (const auto round = through(curves.cubics)) {
      const Round other = with_error(*round, edges, curves);
      if (other.error < best.error) best = other;
    }
  if (!(best.error <= most)) return std::nullopt;
  return best;
}

}  // namespace kerf::drawing
