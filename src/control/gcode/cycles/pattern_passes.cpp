#include "control/gcode/cycles/pattern_passes.hpp"

#include <algorithm>
#include <utility>

#include "control/gcode/cycles/shape_moves.hpp"

namespace kerf::control {

using geometry::Vec2;
using Kind = TurningMove::Kind;

PatternPasses::PatternPasses(TurningShape shape, const PatternSettings& settings)
    : shape_(std::move(shape)), settings_(settings) {
  settings_.passes = std::max(settings.passes, 1U);
  left_ = settings_.passes;
}

bool PatternPasses::advance() {
  if (followed_ < shape_.pieces.size() && begun_) {
    const ShapePiece& piece = shape_.pieces[followed_++];
    add(move_along(piece, shift(), block(piece.block)));
  } else if (left_ > 0) {
    begin_pass();
  } else if (!over_) {
    add({.to = shape_.start});
    over_ = true;
  } else {
    return false;
  }
  return true;
}

void PatternPasses::begin_pass() {
  count_pass();
  --left_;
  begun_ = true;
  followed_ = 0;
  add({.to = shape_.start + shift()});
  add({.kind = shape_.approach_is_rapid ? Kind::rapid : Kind::feed,
       .to = first_point(shape_) + shift(),
       .block = block(shape_.first_block)});
}

Vec2 PatternPasses::shift() const {
  if (left_ == 0) return settings_.allowance;
  const double share = static_cast<double>(left_) / (settings_.passes - 1);
  return settings_.allowance + share * settings_.shift;
}

std::uint32_t PatternPasses::block(std::uint32_t of_shape) const {
  return left_ == 0 ? of_shape : kCycleBlock;
}

}  // namespace kerf::control
