#include "control/gcode/cycles/turning_frame.hpp"

#include <cmath>

namespace kerf::control {
namespace {

using geometry::Vec2;

// Of the way from `from` to whatever point of the shape is farthest, in each axis for itself.
Vec2 farthest(const TurningShape& shape, Vec2 from) {
  Vec2 way = first_point(shape) - from;
  for (const ShapePiece& piece : shape.pieces) {
    const Vec2 other = piece.to - from;
    if (std::fabs(other.u) > std::fabs(way.u)) way.u = other.u;
    if (std::fabs(other.v) > std::fabs(way.v)) way.v = other.v;
  }
  return way;
}

}  // namespace

TurningFrame::TurningFrame(const TurningShape& shape, Travel travel)
    : exchanged_(travel == Travel::along_x) {
  const Vec2 way_in = exchanged(first_point(shape) - shape.start);
  double ahead = exchanged(farthest(shape, first_point(shape))).u;
  if (ahead == 0) ahead = way_in.u;
  double down = way_in.v;
  if (down == 0) down = exchanged(farthest(shape, shape.start)).v;
  // A shape without length or depth: as if it lay before the chuck, outside.
  sign_u_ = ahead > 0 ? 1 : -1;
  sign_v_ = down > 0 ? -1 : 1;
}

Vec2 TurningFrame::exchanged(Vec2 point) const {
  return exchanged_ ? Vec2{point.v, point.u} : point;
}

Vec2 TurningFrame::local(Vec2 in_plane) const {
  const Vec2 point = exchanged(in_plane);
  return {sign_u_ * point.u, sign_v_ * point.v};
}

Vec2 TurningFrame::in_plane(Vec2 local) const {
  return exchanged({sign_u_ * local.u, sign_v_ * local.v});
}

}  // namespace kerf::control
