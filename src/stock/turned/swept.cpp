#include "stock/turned/swept.hpp"

#include <algorithm>

namespace kerf::stock::turned {
namespace {

using contour::Contour;
using contour::Edge;

Contour mirrored(Contour loop) {
  for (contour::Vertex& vertex : loop.vertices) {
    vertex.point.v = -vertex.point.v;
    vertex.bulge = -vertex.bulge;
  }
  return contour::reversed(loop);
}

void append(std::vector<Contour>& loops, std::vector<Contour>&& more) {
  loops.insert(loops.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

void fold(std::vector<Contour>& loops) {
  const std::size_t count = loops.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (contour::extents(loops[i]).low.v < 0) loops.push_back(mirrored(loops[i]));
  }
}

void sign(std::vector<Contour>& loops, std::uint32_t motion) {
  for (Contour& loop : loops) {
    for (contour::Vertex& vertex : loop.vertices) vertex.owner = motion;
  }
}

std::vector<Contour> finished(std::vector<Contour>&& loops, const Pass& pass) {
  fold(loops);
  sign(loops, pass.motion);
  return std::move(loops);
}

}  // namespace

std::vector<Contour> swept(const contour::Region& region, bool is_convex, const Pass& pass) {
  std::vector<Contour> loops;
  for (const Edge& way : pass.path) {
    if (is_convex && way.bulge == 0) {
      loops.push_back(contour::convex_passage(region.loops.front(), way));
    } else {
      append(loops, contour::passage(region, way));
    }
  }
  return finished(std::move(loops), pass);
}

std::vector<Contour> swept(const std::vector<Edge>& edges, const Pass& pass) {
  std::vector<Contour> loops;
  for (const Edge& way : pass.path) append(loops, contour::passage(edges, way));
  return finished(std::move(loops), pass);
}

contour::Box swept_box(const contour::Box& box, const Pass& pass) {
  contour::Box way;
  for (const Edge& edge : pass.path) way.take(contour::extents(edge));
  contour::Box out{box.low + way.low, box.high + way.high};
  if (out.low.v < 0) {
    out.high.v = std::max(out.high.v, -out.low.v);
    out.low.v = 0;
  }
  return out;
}

}  // namespace kerf::stock::turned
