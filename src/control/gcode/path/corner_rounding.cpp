#include "control/gcode/path/corner_rounding.hpp"

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
  return true;
}

// Emits the held move up to the corner and the corner itself; `next` begins behind it.
bool CornerRounding::blend(PathStep& next) {
  if (std::holds_alternative<motion::Rapid>(next.motion.action)) {
    return alarms_.raise_at(Code::corner_not_line, next.place);
  }
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
  if (!fresh_) return refuse();
  fresh_ = false;
  return true;
}

bool CornerRounding::refuse() {
  if (!held_) return true;
  const base::Place place = held_->place;
  if (!let_go()) return false;
  return alarms_.raise_at(Code::corner_missing_move, place);
}

void CornerRounding::reset() {
  held_.reset();
  beside_.clear();
}

}  // namespace kerf::control
