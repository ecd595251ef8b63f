#include "features/milling/contour_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "features/path/tolerance.hpp"
#include "features/tree/normal_form.hpp"
#include "geometry/contour/box_tree.hpp"
#include "geometry/contour/edit.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;
using geometry::Vec2;

/// How far apart arcs are at most that lead from one point to another.
double apart(const Edge& edge, double bulge) {
  return std::fabs(edge.bulge - bulge) * geometry::length(edge.to - edge.from) / 2;
}

bool is_half_circle(const Edge& edge) { return apart(edge, 1) <= kRounded_mm; }

// Two round ends of one radius, opposite each other, and lines or arcs beside each other between.
std::optional<Stadium> stadium_from(const Contour& contour, std::size_t end) {
  const Edge a = contour::edge_of(contour, end);
  const Edge b = contour::edge_of(contour, end + 2);
  const Edge side = contour::edge_of(contour, end + 1);
  const Edge other = contour::edge_of(contour, (end + 3) % 4);
  const double radius = contour::radius(a);
  if (!is_half_circle(a) || !is_half_circle(b) ||
      std::fabs(contour::radius(b) - radius) > kRounded_mm)
    return std::nullopt;
  if ((side.bulge == 0) != (other.bulge == 0)) return std::nullopt;
  if (apart(side, -other.bulge) > kRounded_mm) return std::nullopt;
  Stadium stadium{.width = 2 * radius};
  stadium.centre_line.vertices = {{contour::centre(a), side.bulge, side.owner},
                                  {contour::centre(b), 0, side.owner}};
  const Edge middle{contour::centre(a), contour::centre(b), side.bulge, side.owner};
  stadium.length = contour::length(middle) + stadium.width;
  return stadium;
}

std::vector<Edge> edges_of_rows(const Recording& recording,
                                const std::vector<std::uint32_t>& rows) {
  std::vector<Edge> edges;
  for (const std::uint32_t row : rows) recording.append_edges(row, edges);
  return edges;
}

std::optional<Contour> single_line(const std::vector<Edge>& edges) {
  const Edge& first = edges.front();
  const Vec2 direction = geometry::unit(first.to - first.from);
  double low = 0;
  double high = 0;
  for (const Edge& edge : edges) {
    for (const Vec2 point : {edge.from, edge.to}) {
      const Vec2 arm = point - first.from;
      if (edge.bulge != 0 || std::fabs(geometry::cross(direction, arm)) > kSamePoint_mm)
        return std::nullopt;
      low = std::min(low, geometry::dot(direction, arm));
      high = std::max(high, geometry::dot(direction, arm));
    }
  }
  return Contour{{{first.from + low * direction, 0, first.owner},
                  {first.from + high * direction, 0, first.owner}},
                 false};
}

// Arcs of one circle that go on in one sense and do not come round.
std::optional<Contour> single_arc(const std::vector<Edge>& edges) {
  double sweep = 0;
  Contour path{{}, false};
  for (const Edge& edge : edges) {
    const bool is_same =
        edge.bulge != 0 && (edge.bulge > 0) == (edges.front().bulge > 0) &&
        geometry::length(contour::centre(edge) - contour::centre(edges.front())) <= kSamePoint_mm;
    if (!is_same) return std::nullopt;
    sweep += std::fabs(contour::sweep_rad(edge));
    path.vertices.push_back({edge.from, edge.bulge, edge.owner});
  }
  if (sweep > 2 * std::numbers::pi - 1e-3) return std::nullopt;
  path.vertices.push_back({edges.back().to, 0, edges.back().owner});
  return normal_form(path);
}

double distance_between(const Edge& a, const Edge& b) {
  double least = std::min({contour::distance(a, b.from), contour::distance(a, b.to),
                           contour::distance(b, a.from), contour::distance(b, a.to)});
  const auto crossing = contour::meeting_point(a, b, contour::point_at(a, 0.5));
  if (crossing && contour::distance(a, *crossing) < kSamePoint_mm &&
      contour::distance(b, *crossing) < kSamePoint_mm)
    least = 0;
  return least;
}

}  // namespace

std::optional<Disc> disc_of(const Contour& contour) {
  if (!contour.is_closed || contour.vertices.size() != 2) return std::nullopt;
  const Edge half = contour::edge_of(contour, 0);
  if (!is_half_circle(half) || !is_half_circle(contour::edge_of(contour, 1))) return std::nullopt;
  return Disc{contour::centre(half), contour::radius(half)};
}

std::optional<Stadium> stadium_of(const Contour& contour) {
  if (!contour.is_closed || contour.vertices.size() != 4) return std::nullopt;
  if (const auto stadium = stadium_from(contour, 0)) return stadium;
  return stadium_from(contour, 1);
}

std::optional<Contour> single_element(const Recording& recording,
                                      const std::vector<std::uint32_t>& rows) {
  const std::vector<Edge> edges = edges_of_rows(recording, rows);
  if (edges.empty()) return std::nullopt;
  return edges.front().bulge == 0 ? single_line(edges) : single_arc(edges);
}

bool stays_apart(const Contour& path, double distance) {
  const std::size_t count = contour::edge_count(path);
  std::vector<contour::Box> boxes;
  for (std::size_t i = 0; i < count; ++i)
    boxes.push_back(contour::extents(contour::edge_of(path, i)).grown(distance / 2));
  const contour::BoxTree tree(boxes);
  for (std::size_t i = 0; i < count; ++i) {
    const Edge edge = contour::edge_of(path, i);
    bool is_near = false;
    tree.search(boxes[i], [&](std::uint32_t other) {
      if (is_near || other < i + 2) return;
      is_near = distance_between(edge, contour::edge_of(path, other)) < distance - kSamePoint_mm;
    });
    if (is_near) return false;
  }
  return true;
}

}  // namespace kerf::features
