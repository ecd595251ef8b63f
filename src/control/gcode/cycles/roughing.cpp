#include "control/gcode/cycles/roughing.hpp"

#include <algorithm>
#include <utility>

#include "control/gcode/cycles/shape_moves.hpp"
#include "geometry/tolerance.hpp"

namespace kerf::control {

using geometry::Vec2;
using Kind = TurningMove::Kind;

namespace {

// Less is not programmed: 10^6 levels per millimetre.
constexpr double kLeastDepth_mm = 1e-6;

}  // namespace

Roughing::Roughing(TurningShape shape, const RoughSettings& settings)
    : shape_(std::move(shape)),
      settings_(settings),
      frame_(shape_, settings.travel),
      corner_(frame_.local(shape_.start + settings.allowance)),
      first_(frame_.local(first_point(shape_) + settings.allowance)),
      at_(frame_.local(shape_.start)) {
  settings_.depth_mm = std::max(settings.depth_mm, kLeastDepth_mm);
}

double Roughing::level(std::uint64_t number) const {
  return corner_.v - static_cast<double>(number) * settings_.depth_mm;
}

Kind Roughing::approach_kind() const { return shape_.approach_is_rapid ? Kind::rapid : Kind::feed; }

void Roughing::go(Kind kind, Vec2 to, std::uint32_t block) {
  add({.kind = kind, .to = frame_.in_plane(to), .block = block});
  at_ = to;
}

void Roughing::feed_along(const MonotonePiece& piece, Vec2 to) {
  // An arc between points that are one could be taken for a full circle.
  if (!piece.is_arc || length(to - at_) <= geometry::kSamePoint_mm) return feed_to(to);
  add({.kind = Kind::feed,
       .is_arc = true,
       .clockwise = piece.clockwise != frame_.turns_over(),
       .to = frame_.in_plane(to),
       .centre = frame_.in_plane(piece.centre)});
  at_ = to;
}

bool Roughing::advance() {
  switch (stage_) {
    case Stage::way_in:
      rapid_to(corner_);
      stage_ = Stage::levels;
      return true;
    case Stage::levels:
      if (!cut()) stage_ = Stage::approach;
      return true;
    case Stage::approach:
      approach_shape();
      stage_ = Stage::shape;
      return true;
    case Stage::shape:
      if (!follow_shape()) stage_ = Stage::way_out;
      return true;
    case Stage::way_out:
      add({.to = shape_.start});
      stage_ = Stage::over;
      return true;
    case Stage::over: return false;
  }
  return false;
}

// As ns goes: first down to the height of its end, then to it.
void Roughing::approach_shape() {
  leave();
  go(approach_kind(), {corner_.u, first_.v}, shape_.first_block);
  go(approach_kind(), first_, shape_.first_block);
}

bool Roughing::follow_shape() {
  if (followed_ == shape_.pieces.size()) return false;
  const ShapePiece& piece = shape_.pieces[followed_++];
  add(move_along(piece, settings_.allowance, piece.block));
  return true;
}

}  // namespace kerf::control
