#include "features/milling/nominal.hpp"

#include <optional>
#include <vector>

#include "features/tree/corner.hpp"
#include "features/tree/normal_form.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;
using contour::Vec2;

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
