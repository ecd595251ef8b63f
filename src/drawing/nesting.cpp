#include "drawing/nesting.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/contour/box_tree.hpp"
#include "geometry/contour/tolerance.hpp"

namespace kerf::drawing {
namespace {

using contour::Box;
using contour::Contour;
using contour::Side;

/// Places in turn, until one is not on the border.
bool is_inside(const Contour& inner, const Contour& outer) {
  const std::size_t edges = edge_count(inner);
  for (std::size_t i = 0; i < edges; ++i) {
    const Side side = side_of(outer, point_at(edge_of(inner, i), 0.5), contour::kSame_mm);
    if (side != Side::border) return side == Side::inside;
  }
  return false;
}

bool surrounds(const Box& outer, const Box& inner) {
  return outer.low.u <= inner.low.u && outer.low.v <= inner.low.v && outer.high.u >= inner.high.u &&
         outer.high.v >= inner.high.v;
}

}  // namespace

std::vector<Nest> nests_of(std::span<const Contour> contours) {
  std::vector<Box> boxes;
  std::vector<double> areas;
  for (const Contour& contour : contours) {
    boxes.push_back(extents(contour));
    areas.push_back(contour.is_closed ? std::abs(area(contour)) : 0);
  }
  const contour::BoxTree tree(boxes);
  std::vector<Nest> nests(contours.size());
  for (std::size_t i = 0; i < contours.size(); ++i) {
    tree.search({boxes[i].low, boxes[i].low}, [&](std::size_t k) {
      if (k == i || !contours[k].is_closed || areas[k] <= areas[i]) return;
      if (!surrounds(boxes[k], boxes[i]) || !is_inside(contours[i], contours[k])) return;
      ++nests[i].depth;
      const std::optional<std::size_t>& parent = nests[i].parent;
      const bool is_nearer =
          !parent || areas[k] < areas[*parent] || (areas[k] == areas[*parent] && k < *parent);
      if (is_nearer) nests[i].parent = k;
    });
  }
  return nests;
}

}  // namespace kerf::drawing
