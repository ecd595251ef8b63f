#include "geometry/contour/contour.hpp"

#include <cmath>

#include "geometry/contour/tolerance.hpp"

namespace kerf::contour {
namespace {

template <typename Visit>
void each_edge(const Contour& contour, Visit&& visit) {
  for (std::size_t i = 0; i < edge_count(contour); ++i) visit(edge_of(contour, i));
}

bool is_within_reach(double value) { return std::fabs(value) <= kFarthest_mm; }

/// An arc whose radius has powers that numbers hold, and whose middle is not beyond all reach.
bool is_sound_arc(const Edge& edge) {
  constexpr double kFlattest = 1e-50;
  if (edge.bulge == 0) return true;
  const double rise_mm = edge.bulge * geometry::length(edge.to - edge.from) / 2;
  return std::fabs(edge.bulge) >= kFlattest && is_within_reach(edge.bulge) &&
         is_within_reach(rise_mm);
}

}  // namespace

std::size_t edge_count(const Contour& contour) {
  const std::size_t count = contour.vertices.size();
  if (count < 2) return 0;
  return contour.is_closed ? count : count - 1;
}

Edge edge_of(const Contour& contour, std::size_t index) {
  const Vertex& from = contour.vertices[index];
  const std::size_t next = index + 1 == contour.vertices.size() ? 0 : index + 1;
  return {from.point, contour.vertices[next].point, from.bulge, from.owner};
}

bool is_sound(const Contour& contour) {
  const bool has_places =
      std::all_of(contour.vertices.begin(), contour.vertices.end(), [](const Vertex& vertex) {
        return is_within_reach(vertex.point.u) && is_within_reach(vertex.point.v);
      });
  if (!has_places) return false;
  bool has_arcs = true;
  each_edge(contour, [&](const Edge& edge) { has_arcs = has_arcs && is_sound_arc(edge); });
  return has_arcs;
}

double area(const Contour& contour) {
  if (contour.vertices.empty()) return 0;
  const Vec2 origin = contour.vertices.front().point;
  double sum = 0;
  each_edge(contour, [&](const Edge& edge) { sum += area_about(edge, origin); });
  return sum;
}

double length(const Contour& contour) {
  double sum = 0;
  each_edge(contour, [&](const Edge& edge) { sum += length(edge); });
  return sum;
}

Box extents(const Contour& contour) {
  Box box;
  for (const Vertex& vertex : contour.vertices) box.take(vertex.point);
  each_edge(contour, [&](const Edge& edge) {
    if (edge.bulge != 0) box.take(extents(edge));
  });
  return box;
}

bool is_counterclockwise(const Contour& contour) { return area(contour) > 0; }

Contour reversed(const Contour& contour) {
  const std::size_t count = contour.vertices.size();
  Contour result{{}, contour.is_closed};
  result.vertices.reserve(count);
  for (std::size_t i = count; i-- > 0;) {
    const Vertex& before = contour.vertices[i == 0 ? count - 1 : i - 1];
    result.vertices.push_back({contour.vertices[i].point, -before.bulge, before.owner});
  }
  return result;
}

Vec2 point_at(const Contour& contour, Place place) {
  return point_at(edge_of(contour, place.edge), place.share);
}

Place place_at_length(const Contour& contour, double distance) {
  const std::size_t count = edge_count(contour);
  double ahead = std::max(0.0, distance);
  for (std::size_t i = 0; i < count; ++i) {
    const double here = length(edge_of(contour, i));
    if (ahead < here) return {i, ahead / here};
    ahead -= here;
  }
  return {count - 1, 1};
}

Vec2 midpoint(const Contour& contour) {
  return point_at(contour, place_at_length(contour, length(contour) / 2));
}

Place nearest_place(const Contour& contour, Vec2 point) {
  Place nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < edge_count(contour); ++i) {
    const double here = distance(edge_of(contour, i), point);
    if (here < least) nearest = {i, nearest_share(edge_of(contour, i), point)};
    least = std::min(least, here);
  }
  return nearest;
}

double distance(const Contour& contour, Vec2 point) {
  double least = std::numeric_limits<double>::infinity();
  each_edge(contour, [&](const Edge& edge) { least = std::min(least, distance(edge, point)); });
  return least;
}

Side side_of(const Contour& contour, Vec2 point, double tolerance) {
  if (distance(contour, point) <= tolerance) return Side::border;
  return winding(contour, point) != 0 ? Side::inside : Side::outside;
}

int winding(const Contour& contour, Vec2 point) {
  int sum = 0;
  each_edge(contour, [&](const Edge& edge) { sum += winding(edge, point); });
  return sum;
}

}  // namespace kerf::contour
