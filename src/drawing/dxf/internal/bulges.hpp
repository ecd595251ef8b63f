#pragma once

#include <vector>

#include "drawing/pen.hpp"

namespace kerf::drawing::dxf {

/// A vertex of a polyline, and the bulge of what leads on from it.
struct BulgeVertex {
  Vec2 at;
  double bulge = 0;
};

/// As a path of its own. Points that are the same as the one before are one.
void draw_bulges(const std::vector<BulgeVertex>& vertices, bool is_closed, Pen& pen);

}  // namespace kerf::drawing::dxf
