#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/contour/contour.hpp"

namespace kerf::stock::turned {

/// Holds the edge, without asking how far its arc really goes: quick.
[[nodiscard]] inline contour::Box quick_box(const contour::Edge& edge) {
  contour::Box box;
  box.take(edge.from);
  box.take(edge.to);
  if (edge.bulge == 0) return box;
  // An arc up to half a circle is no farther from its chord than its height, bulge/2 chords.
  const double chord = geometry::length(edge.to - edge.from);
  const double bulge = std::fabs(edge.bulge);
  return box.grown(bulge <= 1 ? chord * bulge / 2 : chord * bulge);
}

[[nodiscard]] inline contour::Box quick_box(const contour::Contour& loop) {
  contour::Box box;
  for (std::size_t i = 0; i < contour::edge_count(loop); ++i)
    box.take(quick_box(contour::edge_of(loop, i)));
  return box;
}

}  // namespace kerf::stock::turned
