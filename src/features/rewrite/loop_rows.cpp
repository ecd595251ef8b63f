#include "features/rewrite/loop_rows.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"
#include "features/tree/normal_form.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;
using contour::Place;

constexpr double kFull = 1 - 1e-9;  // share of an edge that is all of it

bool is_same_circle(const Edge& a, const Edge& b) {
  if (a.bulge == 0 || b.bulge == 0 || std::signbit(a.bulge) != std::signbit(b.bulge)) return false;
  return geometry::length(contour::centre(a) - contour::centre(b)) <= kSamePoint_mm &&
         std::fabs(contour::radius(a) - contour::radius(b)) <= kSamePoint_mm;
}

/// Its centre, if all of it is one circle.
std::optional<Vec2> centre_of_circle(const Contour& loop) {
  const Edge first = contour::edge_of(loop, 0);
  for (std::size_t i = 0; i < contour::edge_count(loop); ++i) {
    if (!is_same_circle(first, contour::edge_of(loop, i))) return std::nullopt;
  }
  return contour::centre(first);
}

Contour begun_at(const Contour& loop, std::size_t vertex) {
  Contour turned = loop;
  std::rotate(turned.vertices.begin(),
              turned.vertices.begin() + static_cast<std::ptrdiff_t>(vertex), turned.vertices.end());
  return turned;
}

Contour begun_at(const Contour& loop, Place place) {
  if (place.share >= kFull) return begun_at(loop, (place.edge + 1) % loop.vertices.size());
  if (place.share <= 1 - kFull) return begun_at(loop, place.edge);
  const Edge edge = contour::edge_of(loop, place.edge);
  const Edge before = contour::part(edge, 0, place.share);
  const Edge behind = contour::part(edge, place.share, 1);
  Contour divided = loop;
  divided.vertices[place.edge].bulge = before.bulge;
  divided.vertices.insert(divided.vertices.begin() + static_cast<std::ptrdiff_t>(place.edge) + 1,
                          {behind.from, behind.bulge, edge.owner});
  return begun_at(divided, place.edge + 1);
}

Vec2 on_circle(const Contour& loop, Vec2 centre, const OldLoop& like) {
  const auto old_centre = centre_of_circle(like.path);
  const Vec2 arm = like.path.vertices.front().point - old_centre.value_or(centre);
  if (geometry::length(arm) == 0) return loop.vertices.front().point;
  return centre + contour::radius(contour::edge_of(loop, 0)) * geometry::unit(arm);
}

}  // namespace

Contour begun_near(const Contour& loop, Vec2 point) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < loop.vertices.size(); ++i) {
    const double better = geometry::length(loop.vertices[best].point - point) - kSamePoint_mm;
    if (geometry::length(loop.vertices[i].point - point) < better) best = i;
  }
  return begun_at(loop, best);
}

Contour begun_beside(const Contour& loop, Vec2 point) {
  return begun_at(loop, contour::nearest_place(loop, point));
}

Contour begun_like(const Contour& loop, const OldLoop& like) {
  const Vec2 start = like.path.vertices.front().point;
  if (const auto centre = centre_of_circle(loop))
    return begun_at(loop, contour::nearest_place(loop, on_circle(loop, *centre, like)));
  if (like.begins_at_corner) return begun_near(loop, start);
  return begun_at(loop, contour::nearest_place(loop, start));
}

void append_loop(const Contour& loop, double z, std::uint32_t like, std::vector<PlannedRow>& rows) {
  const std::size_t count = contour::edge_count(loop);
  for (std::size_t i = 0; i < count;) {
    const Edge first = contour::edge_of(loop, i);
    Edge last = first;
    double sweep = contour::sweep_rad(first);
    for (++i; i < count && is_same_circle(first, contour::edge_of(loop, i)); ++i) {
      last = contour::edge_of(loop, i);
      sweep += contour::sweep_rad(last);
    }
    PlannedRow row{.to = {last.to.u, last.to.v, z}, .like = like};
    if (first.bulge != 0) row.arc = ArcRow{contour::centre(first), sweep};
    rows.push_back(row);
  }
}

}  // namespace kerf::features
