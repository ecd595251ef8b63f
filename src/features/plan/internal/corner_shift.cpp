#include "features/plan/internal/corner_shift.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;
using contour::Vec2;

constexpr double kMostAllowance_mm = 5;  // that a roughing pass leaves beside the contour

/// The point of a line that is at the same place along the axis, or, where it is square to that,
/// from it.
Vec2 on_line(const Edge& line, Vec2 near) {
  const Vec2 way = line.to - line.from;
  if (geometry::length(way) <= kSamePoint_mm) return near;
  const bool is_square = std::fabs(way.u) < std::fabs(way.v);
  const double share = is_square ? (near.v - line.from.v) / way.v : (near.u - line.from.u) / way.u;
  return line.from + share * way;
}

Vec2 swapped(Vec2 point) { return {point.v, point.u}; }
Edge swapped(const Edge& edge) { return {swapped(edge.from), swapped(edge.to), -edge.bulge}; }

/// The places at which an edge has a height v.
void append_places(const Edge& edge, double height, std::vector<double>& places) {
  if (edge.bulge != 0) {
    const Vec2 centre = contour::centre(edge);
    const double radius = contour::radius(edge);
    const double rise = height - centre.v;
    const double half = std::sqrt(std::max(0.0, radius * radius - rise * rise));
    for (const double u : {centre.u - half, centre.u + half}) {
      if (contour::distance(edge, {u, height}) <= kSamePoint_mm) places.push_back(u);
    }
    return;
  }
  const double low = std::min(edge.from.v, edge.to.v) - kSamePoint_mm;
  const double high = std::max(edge.from.v, edge.to.v) + kSamePoint_mm;
  if (height < low || height > high || high - low < 3 * kSamePoint_mm) return;
  const double share = std::clamp((height - edge.from.v) / (edge.to.v - edge.from.v), 0.0, 1.0);
  places.push_back(edge.from.u + share * (edge.to.u - edge.from.u));
}

/// Where a contour has a radius, or, across, a place: the one nearest to `near`.
std::optional<double> place_at(const Contour& contour, double height, double near, bool along_z) {
  std::vector<double> places;
  for (std::size_t i = 0; i < contour::edge_count(contour); ++i) {
    const Edge edge = contour::edge_of(contour, i);
    append_places(along_z ? edge : swapped(edge), height, places);
  }
  std::optional<double> found;
  for (const double place : places) {
    if (!found || std::fabs(place - near) < std::fabs(*found - near)) found = place;
  }
  return found;
}

}  // namespace

bool CornerShift::keeps_elements() const {
  if (before_.vertices.size() != now_.vertices.size()) return false;
  for (std::size_t i = 0; i < before_.vertices.size(); ++i) {
    if (std::fabs(before_.vertices[i].bulge - now_.vertices[i].bulge) > 1e-6) return false;
  }
  return true;
}

std::optional<Vec2> CornerShift::at(Vec2 point, double reach) const {
  std::optional<Vec2> shift;
  for (std::size_t i = 0; i < std::min(before_.vertices.size(), now_.vertices.size()); ++i) {
    const double off = geometry::length(before_.vertices[i].point - point);
    if (off > reach) continue;
    reach = off;
    shift = now_.vertices[i].point - before_.vertices[i].point;
  }
  return shift;
}

std::optional<double> CornerShift::place(Vec2 end, bool along_z) const {
  const Vec2 there = along_z ? end : swapped(end);
  return place_at(before_, there.v, there.u, along_z);
}

std::optional<double> CornerShift::farther(Vec2 end, bool along_z) const {
  const Vec2 there = along_z ? end : swapped(end);
  const auto old_place = place(end, along_z);
  if (!old_place || std::fabs(*old_place - there.u) > kMostAllowance_mm) return std::nullopt;
  const auto new_place = place_at(now_, there.v, *old_place, along_z);
  return new_place ? std::optional(*new_place - *old_place) : std::nullopt;
}

std::optional<Vec2> CornerShift::before_element(Vec2 from, Vec2 to) const {
  for (std::size_t i = 0; i < contour::edge_count(before_); ++i) {
    const Edge was = contour::edge_of(before_, i);
    const Edge is = contour::edge_of(now_, i);
    if (was.bulge != 0 || geometry::length(was.to - to) > kSamePoint_mm) continue;
    const Vec2 way = geometry::unit(was.to - was.from);
    const Vec2 arm = from - was.to;
    const bool is_before = geometry::dot(way, arm) < 0;
    if (!is_before || std::fabs(geometry::cross(way, arm)) > kSamePoint_mm) continue;
    return on_line(is, from) - from;
  }
  return std::nullopt;
}

}  // namespace kerf::features
