#include "features/milling/strategy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "features/milling/passes.hpp"
#include "features/path/tolerance.hpp"
#include "geometry/angle.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;

constexpr std::size_t kMostWallSamples = 4096;
constexpr double kBothShare = 0.05;  // of the walls' length, below which one side does not count

std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A loop that is one circle; nothing: it is none.
std::optional<ArcRow> circle_row(const Recording& recording, const Loop& loop) {
  if (loop.rows.first != loop.rows.last) return std::nullopt;
  if (recording.moves[loop.rows.first].shape != Move::Shape::arc) return std::nullopt;
  return recording.arc_of(loop.rows.first);
}

// Circles smaller than the tool that move on by less than it.
bool is_trochoidal(const Recording& recording, const ShapedLevel& shaped) {
  const double diameter = 2 * shaped.level.radius;
  std::size_t moved = 0;
  std::optional<Vec2> last;
  for (const Loop& loop : shaped.loops.loops) {
    const auto circle = circle_row(recording, loop);
    if (!circle || std::sqrt(std::fabs(loop.area) / std::numbers::pi) >= diameter) return false;
    const double way = last ? geometry::length(circle->centre - *last) : 0;
    if (way >= diameter) return false;
    moved += static_cast<std::size_t>(way > kSamePoint_mm);
    last = circle->centre;
  }
  return moved >= 2 && moved * 2 >= shaped.loops.loops.size();
}

double length_of(const Recording& recording, const std::vector<std::uint32_t>& rows) {
  double sum = 0;
  for (const std::uint32_t row : rows) sum += recording.length_of(row);
  return sum;
}

// Between loops that follow each other, from the smaller one's corners to the other.
std::vector<double> loop_distances(const Recording& recording, const ShapedLevel& shaped) {
  constexpr std::size_t kSamples = 16;
  std::vector<double> distances;
  const auto& loops = shaped.loops.loops;
  for (std::size_t i = 1; i < loops.size(); ++i) {
    Contour a = recording.contour_of(loops[i - 1].rows);
    Contour b = recording.contour_of(loops[i].rows);
    if (loops[i - 1].perimeter > loops[i].perimeter) std::swap(a, b);
    const std::size_t step = std::max<std::size_t>(1, a.vertices.size() / kSamples);
    std::vector<double> samples;
    for (std::size_t k = 0; k < a.vertices.size(); k += step)
      samples.push_back(contour::distance(b, a.vertices[k].point));
    distances.push_back(*median(samples));
  }
  return distances;
}

/// Much longer than round what it lies in: a zig-zag that comes back to where it began.
bool comes_back_to_itself(const Recording& recording, const Loop& loop) {
  const contour::Box box = contour::extents(recording.contour_of(loop.rows));
  return loop.perimeter > 3 * (box.high.u - box.low.u + box.high.v - box.low.v);
}

/// Loops and the single rows that lead from one to the next: how straight their sides are does not
/// count.
bool is_loops_alone(const Recording& recording, const ShapedLevel& shaped) {
  const auto& loops = shaped.loops.loops;
  return loops.size() >= 2 && shaped.loops.links.size() <= loops.size() &&
         std::none_of(loops.begin(), loops.end(),
                      [&](const Loop& loop) { return comes_back_to_itself(recording, loop); });
}

// No closed loop but the last one, and round the middle more than twice.
bool is_spiral(const Recording& recording, const ShapedLevel& shaped) {
  if (shaped.loops.loops.size() > 1 || shaped.level.runs.size() != 1) return false;
  const contour::Box box = contour::extents(shaped.layer.contour);
  if (box.is_empty()) return false;
  std::vector<Edge> edges;
  for (const std::uint32_t row : shaped.level.rows(recording)) recording.append_edges(row, edges);
  double turn = 0;
  for (const Edge& edge : edges) {
    // By its middle: half a circle goes round on a side of its own.
    const std::array<Vec2, 3> points{edge.from - box.middle(),
                                     contour::point_at(edge, 0.5) - box.middle(),
                                     edge.to - box.middle()};
    for (std::size_t i = 1; i < points.size(); ++i)
      turn += math::atan2(geometry::cross(points[i - 1], points[i]),
                          geometry::dot(points[i - 1], points[i]));
  }
  if (std::fabs(turn) <= 4 * std::numbers::pi) return false;
  const std::size_t step = 1 + edges.size() / kMostWallSamples;
  std::optional<double> last;
  int sense = 0;
  for (std::size_t i = 0; i < edges.size(); i += step) {
    const double wall = contour::distance(shaped.layer.contour, edges[i].to);
    if (last && std::fabs(wall - *last) > 10 * kSamePoint_mm) {
      const int way = wall > *last ? 1 : -1;
      if (sense != 0 && way != sense) return false;
      sense = way;
    }
    last = wall;
  }
  return sense != 0;
}

/// How much of the walls lies to the right of the feed, and how much to the left.
struct Sides {
  double right = 0;
  double left = 0;
};

Vec2 direction_near(const Edge& edge, Vec2 point) {
  const double share = contour::nearest_share(edge, point);
  if (share > 0.5) return contour::tangent_at_end(contour::part(edge, 0, share));
  return contour::tangent_at_start(contour::part(edge, share, 1));
}

/// The edge of a row that runs beside a point.
std::optional<Edge> edge_near(const Recording& recording, std::uint32_t row, Vec2 point) {
  std::vector<Edge> edges;
  recording.append_edges(row, edges);
  if (edges.empty()) return std::nullopt;
  return *std::min_element(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) {
    return contour::distance(a, point) < contour::distance(b, point);
  });
}

// About one centre the senses tell it: the wall may go on farther than the row that owns it.
bool go_one_way(const Edge& wall, const Edge& row) {
  const Vec2 point = contour::point_at(wall, 0.5);
  if (wall.bulge != 0 && row.bulge != 0 &&
      geometry::length(contour::centre(wall) - contour::centre(row)) <= kRounded_mm)
    return (wall.bulge > 0) == (row.bulge > 0);
  const Vec2 along = contour::tangent_at_start(contour::part(wall, 0.5, 1));
  return geometry::dot(along, direction_near(row, point)) > 0;
}

// What is cut lies on the left of `wall`, and what stays on its right.
void count_wall(const Recording& recording, const Edge& wall, Sides& sides) {
  if (wall.owner >= recording.count()) return;
  const Move& move = recording.moves[wall.owner];
  if (!move.cuts()) return;
  const Vec2 point = contour::point_at(wall, 0.5);
  const auto edge = edge_near(recording, wall.owner, point);
  if (!edge || (wall.bulge != 0 && edge->bulge == 0)) return;
  const bool is_right = go_one_way(wall, *edge) != (recording.state_of(move).turning ==
                                                    motion::Spindle::Turning::counterclockwise);
  (is_right ? sides.right : sides.left) += contour::length(wall);
}

}  // namespace

Clearing clearing_of(const Recording& recording, const ShapedLevel& shaped) {
  const auto& loops = shaped.loops.loops;
  const LinePasses passes = line_passes_of(recording, shaped);
  if (loops.size() >= 2 && is_trochoidal(recording, shaped)) return {Strategy::trochoidal, {}};
  if (passes.clears && !is_loops_alone(recording, shaped)) {
    return {passes.goes_both_ways ? Strategy::zig_zag : Strategy::zig, median(passes.steps)};
  }
  const double links = length_of(recording, shaped.loops.links);
  double round = 0;
  for (const Loop& loop : loops) round += loop.perimeter;
  const bool is_round = !loops.empty() && links < round;
  if (loops.size() == 1 && is_round) return {Strategy::single, {}};
  if (is_round) return {Strategy::contour_parallel, median(loop_distances(recording, shaped))};
  if (shaped.ring) return {Strategy::single, {}};
  if (is_spiral(recording, shaped)) return {Strategy::spiral, {}};
  return {passes.is_one_way ? Strategy::single : Strategy::adaptive, {}};
}

Order order_of(const std::vector<Loop>& loops) {
  if (loops.empty()) return Order::undefined;
  const double difference = loops.back().perimeter - loops.front().perimeter;
  if (std::fabs(difference) <= kSamePoint_mm) return Order::undefined;
  return difference > 0 ? Order::inside_out : Order::outside_in;
}

Milling milling_of(const Recording& recording, const std::vector<const Contour*>& outlines,
                   const std::vector<const Contour*>& islands) {
  Sides sides;
  for (const Contour* const outline : outlines) {
    for (std::size_t i = 0; i < contour::edge_count(*outline); ++i)
      count_wall(recording, contour::edge_of(*outline, i), sides);
  }
  for (const Contour* const island : islands) {
    for (std::size_t i = 0; i < contour::edge_count(*island); ++i)
      count_wall(recording, contour::reversed(contour::edge_of(*island, i)), sides);
  }
  const double all = sides.left + sides.right;
  if (all <= 0) return Milling::undefined;
  if (std::min(sides.left, sides.right) > kBothShare * all) return Milling::both;
  return sides.right > sides.left ? Milling::climb : Milling::conventional;
}

}  // namespace kerf::features
