#include "control/gcode/path/corner_rounding.hpp"

#include <cmath>
#include <utility>

#include "base/decimal.hpp"

namespace kerf::control {
namespace {

using base::Code;
using geometry::Vec2;

Vec2 tidied(Vec2 point) { return {base::tidy(point.u), base::tidy(point.v)}; }

// The step with its end moved to `to`.
PathStep ended_at(PathStep step, Vec2 to, const motion::PlaneAxes& axes) {
  step.piece.to = tidied(to);
  std::visit(
      [&](auto& action) {
        if constexpr (requires { action.to; }) axes.place(action.to, step.piece.to);
      },
      step.motion.action);
  return step;
}

motion::Feed feed_of(const motion::Motion& motion) {
  if (const auto* const line = std::get_if<motion::Line>(&motion.action)) return line->feed;
  if (const auto* const arc = std::get_if<motion::Arc>(&motion.action)) return arc->feed;
  return {};
}

}  // namespace

bool CornerRounding::move(const PathStep& step, motion::Plane plane, const motion::PlaneAxes& axes,
                          const std::optional<Request>& request) {
  PathStep next = step;
  if (held_ && !blend(next)) return false;
  if (!request || request->size_mm <= 0) return forward_(next);
  held_ = next;
  request_ = *request;
  plane_ = plane;
  axes_ = axes;
  fresh_ = true;
  idle_blocks_ = 0;
  return true;
}

// I and K of a lathe: the next move goes along one axis, to the side of their sign.
bool CornerRounding::check_next(const PathStep& next) {
  const bool fast = std::holds_alternative<motion::Rapid>(next.motion.action);
  if (fast || (request_.between_lines && next.piece.is_arc))
    return alarms_.raise_at(Code::corner_not_line, next.place);
  if (!request_.toward) return true;
  const Vec2 way = next.piece.to - next.piece.from;
  if (std::fabs(geometry::cross(*request_.toward, way)) > kAlongAxis_mm)
    return alarms_.raise_at(Code::corner_taper, next.place);
  if (geometry::dot(*request_.toward, way) > 0) return true;
  alarms_.raise_at(Code::corner_too_short, held_->place,
                   "the next move goes to the other side than the sign of I or K says");
  reset();
  return false;
}

// Emits the held move up to the corner and the corner itself; `next` begins behind it.
bool CornerRounding::blend(PathStep& next) {
  if (!check_next(next)) return false;
  if (geometry::is_smooth(held_->piece, next.piece)) return let_go();
  const auto blend = request_.kind == Kind::radius
                         ? geometry::fillet(held_->piece, next.piece, request_.size_mm)
                         : geometry::chamfer(held_->piece, next.piece, request_.size_mm);
  if (!blend) {
    alarms_.raise_at(Code::corner_too_short, held_->place);
    reset();  // the machine stops before a move that it cannot make
    return false;
  }
  const PathStep first = inner_part(ended_at(*held_, blend->begin, axes_));
  PathStep corner = ended_at(*held_, blend->end, axes_);
  corner.piece = {first.piece.to, tidied(blend->end), blend->is_arc, blend->clockwise,
                  blend->centre};
  const base::TipPoint to = *motion::target_of(corner.motion);
  const motion::Feed feed = feed_of(held_->motion);
  if (blend->is_arc) {
    corner.motion.action = motion::Arc{
        to,
        {base::tidy(blend->centre.u), base::tidy(blend->centre.v)},
        feed,
        0,
        plane_,
        blend->clockwise ? motion::Direction::clockwise : motion::Direction::counterclockwise};
  } else {
    corner.motion.action = motion::Line{to, feed};
  }
  next.piece.from = corner.piece.to;
  *held_ = first;
  return let_go() && forward_(corner);
}

bool CornerRounding::let_go() {
  const PathStep step = *held_;
  held_.reset();
  if (step.piece.from != step.piece.to && !forward_(step)) return false;
  for (const motion::Motion& motion : beside_) pass_(motion);
  beside_.clear();
  return true;
}

bool CornerRounding::end_block() {
  if (!held_) return true;
  if (std::exchange(fresh_, false)) return true;
  if (!request_.between_lines) return refuse();
  return ++idle_blocks_ <= kMostIdleBlocks || refuse(Code::drawing_format);
}

bool CornerRounding::refuse_other_move() {
  return refuse(request_.between_lines ? Code::corner_not_line : Code::corner_missing_move);
}

bool CornerRounding::refuse(Code code) {
  if (!held_) return true;
  const base::Place place = held_->place;
  if (!let_go()) return false;
  return alarms_.raise_at(code, place);
}

void CornerRounding::reset() {
  held_.reset();
  beside_.clear();
}

}  // namespace kerf::control
