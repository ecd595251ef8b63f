#include "control/gcode/cycles/shape_check.hpp"

#include <algorithm>
#include <utility>

#include "control/gcode/cycles/monotone_piece.hpp"
#include "geometry/tolerance.hpp"

namespace kerf::control {
namespace {

using geometry::kSamePoint_mm;
using geometry::Vec2;
using Reason = ShapeFault::Reason;

// Follows a shape in the turning frame.
class Follower {
 public:
  Follower(Vec2 start, Vec2 first, Vec2 tolerance, bool pockets)
      : start_(start), reached_(first), tolerance_(tolerance), pockets_(pockets) {}

  [[nodiscard]] bool outside(Vec2 point) const {
    return point.u < start_.u - kSamePoint_mm || point.v > start_.v + kSamePoint_mm;
  }
  std::optional<Reason> go_to(Vec2 point) {
    if (point.u < reached_.u - tolerance_.u - kSamePoint_mm) return Reason::not_monotone_first_axis;
    if (!pockets_ && point.v < reached_.v - tolerance_.v - kSamePoint_mm)
      return Reason::not_monotone_second_axis;
    if (outside(point)) return Reason::outside_start;
    reached_ = {std::max(reached_.u, point.u), std::max(reached_.v, point.v)};
    return std::nullopt;
  }

 private:
  Vec2 start_;
  Vec2 reached_;  // farthest in each axis
  Vec2 tolerance_;
  bool pockets_;
};

}  // namespace

// The area that the shape and the ways between its ends and the start run round.
double side_of_start(const TurningShape& shape) {
  double twice_area = 0;
  for (const ShapePiece& piece : shape.pieces)
    twice_area += geometry::cross(piece.from - shape.start, piece.to - shape.start);
  return twice_area;
}

std::optional<ShapeFault> check_shape(const TurningShape& shape, Travel travel, Vec2 tolerance) {
  const TurningFrame frame(shape, travel);
  const Vec2 first = frame.local(first_point(shape));
  if (travel == Travel::along_x) std::swap(tolerance.u, tolerance.v);
  Follower follower(frame.local(shape.start), first, tolerance, may_have_pockets(shape, travel));
  if (follower.outside(first)) return ShapeFault{Reason::outside_start, shape.first_block};
  for (const MonotonePiece& piece : monotone_pieces(shape, frame, {})) {
    if (const auto reason = follower.go_to(piece.to)) return ShapeFault{*reason, piece.block};
  }
  return std::nullopt;
}

}  // namespace kerf::control
