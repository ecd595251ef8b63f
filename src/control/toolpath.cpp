#include "control/toolpath.hpp"

namespace kerf::control {

using base::AxisVector;

void Toolpath::begin_block(const Source& source) {
  source_ = source;
  ending_ = false;
  moved_in_plane_ = false;
}

bool Toolpath::end_block() {
  if (!compensation_.active()) return true;
  if (ending_ && !moved_in_plane_) {
    compensation_.end();
    ending_ = false;
    return !alarms_.alarm();
  }
  return moved_in_plane_ || compensation_.idle_block();
}

void Toolpath::end_compensation(std::optional<geometry::Vec2> wall) {
  ending_ = true;
  wall_ = wall;
}

bool Toolpath::rapid(const AxisVector& from, const AxisVector& to) {
  return move(from, make(Rapid{to}), nullptr);
}

bool Toolpath::line(const AxisVector& from, const AxisVector& to, const Feed& feed) {
  return move(from, make(Line{to, feed}), nullptr);
}

bool Toolpath::arc(const AxisVector& from, const AxisVector& to, const ArcShape& shape,
                   const Feed& feed) {
  const Arc arc{
      to, {shape.centre.u, shape.centre.v}, feed, shape.turns, shape.plane, shape.direction};
  return move(from, make(arc), &shape);
}

bool Toolpath::straight(const Motion::Action& action) {
  if (!compensation_.active()) {
    emit(make(action));
    return true;
  }
  if (!compensation_.interrupt()) return false;
  tip_ = compensation_.tip();
  emit(make(action));
  compensation_.set_tip(tip_);
  return true;
}

void Toolpath::act(const Motion::Action& action) {
  if (compensation_.active()) {
    compensation_.beside(make(action));
  } else {
    sink_.take(make(action));
  }
}

bool Toolpath::move(const AxisVector& from, const Motion& motion, const ArcShape* shape) {
  if (!compensation_.active()) {
    emit(motion);
    compensation_.set_tip(tip_);
    return true;
  }
  const PlaneAxes& plane = compensation_.plane();
  const AxisVector& to = *target_of(motion);
  const PathStep step{.motion = motion,
                      .place = {},
                      .from = plane.project(from),
                      .to = plane.project(to),
                      .is_arc = shape != nullptr,
                      .clockwise = shape != nullptr && shape->direction == Direction::clockwise,
                      .centre = shape != nullptr ? shape->centre : geometry::Vec2{}};
  if (shape == nullptr && step.from == step.to) {
    compensation_.beside(motion);
    return true;
  }
  moved_in_plane_ = true;
  PathStep placed = step;
  placed.place = alarms_.place();
  const bool good = ending_ ? compensation_.end_with(placed, wall_) : compensation_.move(placed);
  if (!compensation_.active()) tip_ = compensation_.tip();
  return good;
}

// A rapid or line that goes nowhere is no motion; an arc that ends where it begins is a full
// circle.
void Toolpath::emit(const Motion& motion) {
  if (const AxisVector* const to = target_of(motion)) {
    const bool straight_line =
        std::holds_alternative<Rapid>(motion.action) || std::holds_alternative<Line>(motion.action);
    if (straight_line && *to == tip_) return;
    tip_ = *to;
  }
  sink_.take(motion);
}

}  // namespace kerf::control
