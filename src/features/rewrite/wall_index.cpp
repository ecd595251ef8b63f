#include "features/rewrite/wall_index.hpp"

#include <algorithm>

namespace kerf::features {
namespace {

using contour::Box;
using contour::Contour;
using contour::Vec2;

double distance_to(const Box& box, Vec2 point) {
  const double u = std::max({box.low.u - point.u, 0.0, point.u - box.high.u});
  const double v = std::max({box.low.v - point.v, 0.0, point.v - box.high.v});
  return geometry::length(Vec2{u, v});
}

}  // namespace

WallIndex::WallIndex(const Contour& wall) : wall_(wall), edges_(boxes_of(wall)) {}

// Item i has vertex i; of an open contour the last one has no edge.
std::vector<Box> WallIndex::boxes_of(const Contour& wall) {
  std::vector<Box> boxes(wall.vertices.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    boxes[i].take(wall.vertices[i].point);
    if (i < contour::edge_count(wall)) boxes[i].take(contour::extents(contour::edge_of(wall, i)));
  }
  return boxes;
}

Box WallIndex::box_round(Vec2 point, double reach) { return Box{point, point}.grown(reach); }

double WallIndex::distance(Vec2 point, double most) const {
  const auto order = edges_.order();
  edges_.walk(
      [&](std::size_t, std::size_t, const Box& box) { return distance_to(box, point) < most; },
      [&](std::size_t place) {
        const std::size_t edge = order[place];
        if (edge < contour::edge_count(wall_))
          most = std::min(most, contour::distance(contour::edge_of(wall_, edge), point));
      });
  return most;
}

}  // namespace kerf::features
