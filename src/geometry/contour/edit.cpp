#include "geometry/contour/edit.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/contour/tolerance.hpp"
#include "geometry/corner.hpp"
#include "geometry/intersect.hpp"
#include "math/math.hpp"

namespace kerf::contour {
namespace {

using geometry::Curve;
using geometry::left_of;

// The line or circle of an edge, moved to the left by `aside`. A radius below 0: nothing is there.
Curve curve_of(const Edge& edge, double aside) {
  if (edge.bulge == 0) {
    const Vec2 way = geometry::unit(edge.to - edge.from);
    return {false, edge.from + aside * left_of(way), way, 0};
  }
  return {true, centre(edge), {}, radius(edge) - std::copysign(aside, aside * edge.bulge)};
}

// The point of the line or circle of an edge that is nearest to `point`.
Vec2 foot_on(const Edge& edge, Vec2 point) {
  if (edge.bulge != 0) return centre(edge) + radius(edge) * geometry::unit(point - centre(edge));
  const Vec2 way = geometry::unit(edge.to - edge.from);
  return edge.from + dot(point - edge.from, way) * way;
}

// The angle from `from` on, in the direction of `sign`, to `to`: in [0, 2π).
double angle_ahead(Vec2 from, Vec2 to, double sign) {
  const double angle = sign * math::atan2(cross(from, to), dot(from, to));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

double bulge_about(Vec2 middle, Vec2 from, Vec2 to, double sign) {
  return sign * math::tan(angle_ahead(from - middle, to - middle, sign) / 4);
}

Edge between(const Edge& edge, Vec2 from, Vec2 to) {
  const double bulge =
      edge.bulge == 0 ? 0 : bulge_about(centre(edge), from, to, std::copysign(1.0, edge.bulge));
  return {from, to, bulge, edge.owner};
}

geometry::Piece piece_of(const Edge& edge) {
  if (edge.bulge == 0) return {edge.from, edge.to, false, false, {}};
  return {edge.from, edge.to, true, edge.bulge < 0, centre(edge)};
}

struct Nearest {
  std::optional<Vec2> point;
  double distance = std::numeric_limits<double>::infinity();

  void take(Vec2 candidate, Vec2 near) {
    const double here = geometry::length(candidate - near);
    if (here >= distance) return;
    point = candidate;
    distance = here;
  }
};

void take_meetings(Nearest& nearest, const Curve& a, const Curve& b, Vec2 near) {
  if (a.radius < 0 || b.radius < 0) return;
  const geometry::Intersections found = geometry::intersect(a, b, kSame_mm);
  for (std::size_t i = 0; i < found.count; ++i) nearest.take(found.points[i], near);
}

// A corner of a contour: its two edges by number.
struct Corner {
  std::size_t before = 0;
  std::size_t after = 0;
  Edge first;
  Edge second;
};

Corner corner_of(const Contour& contour, std::size_t vertex) {
  const std::size_t before = vertex == 0 ? contour.vertices.size() - 1 : vertex - 1;
  return {before, vertex, edge_of(contour, before), edge_of(contour, vertex)};
}

// The contour with an edge `blend` in place of the corner.
Contour with_blend(Contour contour, const Corner& corner, const Edge& blend) {
  const double bulge = between(corner.second, blend.to, corner.second.to).bulge;
  contour.vertices[corner.before].bulge =
      between(corner.first, corner.first.from, blend.from).bulge;
  contour.vertices[corner.after] = {blend.from, blend.bulge, blend.owner};
  const auto behind = contour.vertices.begin() + static_cast<std::ptrdiff_t>(corner.after) + 1;
  contour.vertices.insert(behind, {blend.to, bulge, corner.second.owner});
  return contour;
}

// What an arc would need of an edge: the length from the corner to where it touches.
double need_of(const Edge& edge, Vec2 corner, const std::optional<Edge>& arc, bool is_first) {
  if (!arc) return std::numeric_limits<double>::infinity();
  const Vec2 touched = is_first ? arc->from : arc->to;
  return is_first ? length(between(edge, touched, corner)) : length(between(edge, corner, touched));
}

DoesNotFit lack(const Corner& corner, double needs_first, double needs_second) {
  const double has_first = length(corner.first);
  const double has_second = length(corner.second);
  if (needs_first - has_first >= needs_second - has_second) {
    return {corner.before, needs_first, has_first};
  }
  return {corner.after, needs_second, has_second};
}

}  // namespace

std::optional<Vec2> meeting_point(const Edge& first, const Edge& second, Vec2 near) {
  Nearest nearest;
  take_meetings(nearest, curve_of(first, 0), curve_of(second, 0), near);
  return nearest.point;
}

Edge with_start(const Edge& edge, Vec2 point) { return between(edge, point, edge.to); }
Edge with_end(const Edge& edge, Vec2 point) { return between(edge, edge.from, point); }

std::optional<std::pair<Edge, Edge>> join(const Edge& first, const Edge& second) {
  const auto meeting = meeting_point(first, second, 0.5 * (first.to + second.from));
  if (!meeting) return std::nullopt;
  return std::pair{with_end(first, *meeting), with_start(second, *meeting)};
}

std::optional<Edge> touching_arc(const Edge& first, const Edge& second, double radius, Vec2 near) {
  Nearest nearest;
  for (const double a : {-radius, radius}) {
    for (const double b : {-radius, radius}) {
      take_meetings(nearest, curve_of(first, a), curve_of(second, b), near);
    }
  }
  if (!nearest.point) return std::nullopt;
  const Vec2 middle = *nearest.point;
  const Vec2 from = foot_on(first, middle);
  const Vec2 to = foot_on(second, middle);
  const double sign = cross(from - middle, to - middle) < 0 ? -1 : 1;
  return Edge{from, to, bulge_about(middle, from, to, sign), first.owner};
}

Edited fillet(const Contour& contour, std::size_t corner, double radius) {
  const Corner here = corner_of(contour, corner);
  const geometry::Piece first = piece_of(here.first);
  const geometry::Piece second = piece_of(here.second);
  if (geometry::is_smooth(first, second)) return contour;
  const auto blend = geometry::fillet(first, second, radius);
  if (!blend) {
    const auto arc = touching_arc(here.first, here.second, radius, here.first.to);
    return tl::make_unexpected(lack(here, need_of(here.first, here.first.to, arc, true),
                                    need_of(here.second, here.first.to, arc, false)));
  }
  const double bulge =
      bulge_about(blend->centre, blend->begin, blend->end, blend->clockwise ? -1 : 1);
  return with_blend(contour, here, {blend->begin, blend->end, bulge, here.first.owner});
}

Edited chamfer(const Contour& contour, std::size_t corner, double before, double after) {
  const Corner here = corner_of(contour, corner);
  const double has_first = length(here.first);
  const double has_second = length(here.second);
  if (before > has_first || after > has_second) {
    return tl::make_unexpected(lack(here, before, after));
  }
  return with_blend(contour, here,
                    {point_at(here.first, 1 - before / has_first),
                     point_at(here.second, after / has_second), 0, here.first.owner});
}

}  // namespace kerf::contour
