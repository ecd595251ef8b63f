#include "features/path/recording.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using contour::Edge;

constexpr double kTurn_rad = 2 * std::numbers::pi;

Vec2 turned(Vec2 arm, double angle_rad) {
  const double c = math::cos(angle_rad);
  const double s = math::sin(angle_rad);
  return {c * arm.u - s * arm.v, s * arm.u + c * arm.v};
}

}  // namespace

Vec3 Recording::from(std::uint32_t row) const {
  if (row == 0) return start;
  const auto begin = begins.find(row);
  return begin == begins.end() ? moves[row - 1].to : begin->second;
}

double Recording::length_of(std::uint32_t row) const {
  const Move& move = moves[row];
  if (move.shape == Move::Shape::other) return lengths[move.shaped];
  const Vec3 begin = from(row);
  if (move.shape == Move::Shape::line) return geometry::length(move.to - begin);
  const ArcRow& arc = arc_of(row);
  const double radius =
      (geometry::length(flat(begin) - arc.centre) + geometry::length(flat(move.to) - arc.centre)) /
      2;
  const double rise = turns ? move.to.y - begin.y : move.to.z - begin.z;
  return math::hypot(radius * std::fabs(arc.sweep_rad), rise);
}

double Recording::length_of(Span span) const {
  double sum = 0;
  for (std::uint32_t row = span.first; row <= span.last; ++row) {
    if (moves[row].kind != Move::Kind::rapid) sum += length_of(row);
  }
  return sum;
}

bool Recording::goes_across(std::uint32_t row) const {
  if (moves[row].shape == Move::Shape::arc) return true;
  return geometry::length(flat_to(row) - flat_from(row)) > kSamePoint_mm;
}

// Whole turns beyond the first go along the same circle.
void Recording::append_edges(std::uint32_t row, std::vector<Edge>& edges) const {
  const Vec2 begin = flat_from(row);
  const Vec2 end = flat_to(row);
  if (moves[row].shape != Move::Shape::arc) {
    if (!(begin == end)) edges.push_back({begin, end, 0, row});
    return;
  }
  features::append_edges(begin, end, arc_of(row), row, edges);
}

void append_edges(Vec2 begin, Vec2 end, const ArcRow& arc, std::uint32_t owner,
                  std::vector<Edge>& edges) {
  double sweep = arc.sweep_rad;
  while (std::fabs(sweep) > kTurn_rad * (1 + 1e-9)) sweep -= std::copysign(kTurn_rad, sweep);
  const int parts =
      std::max(1, static_cast<int>(std::ceil(std::fabs(sweep) / std::numbers::pi - 1e-9)));
  const double bulge = math::tan(sweep / parts / 4);
  Vec2 at = begin;
  for (int part = 1; part <= parts; ++part) {
    const Vec2 to =
        part == parts ? end : arc.centre + turned(begin - arc.centre, sweep * part / parts);
    edges.push_back({at, to, bulge, owner});
    at = to;
  }
}

contour::Contour Recording::contour_of(Span rows) const {
  std::vector<Edge> edges;
  for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
    if (moves[row].cuts() && goes_across(row)) append_edges(row, edges);
  }
  contour::Contour contour;
  contour.vertices.reserve(edges.size());
  for (const Edge& edge : edges) contour.vertices.push_back({edge.from, edge.bulge, edge.owner});
  return contour;
}

}  // namespace kerf::features
