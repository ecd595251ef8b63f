#include "features/milling/nominal.hpp"

#include <cmath>
#include <optional>
#include <vector>

#include "features/tree/normal_form.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;
using contour::Vec2;

constexpr double kSmooth = 1e-3;    // sine of the angle at which an arc goes over into a line
constexpr double kParallel = 1e-4;  // of lines that meet nowhere near

bool is_smooth(Vec2 a, Vec2 b) {
  return std::fabs(geometry::cross(geometry::unit(a), geometry::unit(b))) < kSmooth &&
         geometry::dot(a, b) > 0;
}

/// Where the line before an arc and the one behind it meet; nothing: the arc is no rounded corner.
std::optional<Vec2> corner_of(const Edge& before, const Edge& arc, const Edge& behind) {
  if (before.bulge != 0 || behind.bulge != 0) return std::nullopt;
  const Vec2 in = contour::tangent_at_start(arc);
  const Vec2 out = contour::tangent_at_end(arc);
  if (!is_smooth(before.to - before.from, in) || !is_smooth(out, behind.to - behind.from))
    return std::nullopt;
  const Vec2 u = geometry::unit(before.to - before.from);
  const Vec2 v = geometry::unit(behind.to - behind.from);
  const double sine = geometry::cross(u, v);
  if (std::fabs(sine) < kParallel || std::fabs(arc.bulge) >= 1) return std::nullopt;
  const double along = geometry::cross(behind.from - before.to, v) / sine;
  return before.to + along * u;
}

}  // namespace

Contour sharpened(const Contour& contour, bool is_island, const IsToolCorner& is_tool_corner) {
  const std::size_t count = contour.vertices.size();
  if (!contour.is_closed || count < 3) return contour;
  std::vector<std::optional<Vec2>> corners(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Edge arc = contour::edge_of(contour, i);
    if (arc.bulge == 0 || (arc.bulge > 0) == is_island || !is_tool_corner(arc)) continue;
    corners[i] = corner_of(contour::edge_of(contour, (i + count - 1) % count), arc,
                           contour::edge_of(contour, (i + 1) % count));
  }
  // An arc's begin becomes the corner, and its end goes: the line behind begins in the corner.
  Contour sharp{{}, true};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    if (corners[i]) continue;
    const Vec2 at = corners[before] ? *corners[before] : contour.vertices[i].point;
    sharp.vertices.push_back({at, contour.vertices[i].bulge, contour.vertices[i].owner});
  }
  return normal_form(sharp);
}

}  // namespace kerf::features
