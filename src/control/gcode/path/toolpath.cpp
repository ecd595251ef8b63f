#include "control/gcode/path/toolpath.hpp"

#include <utility>

namespace kerf::control {

using base::PathPoint;
using base::TipPoint;

Toolpath::Toolpath(Alarms& alarms, Outlet& outlet, const CutterCompensation::Settings& settings,
                   const motion::AxisSetup& axes)
    : alarms_(alarms),
      outlet_(axes, outlet),
      corners_(
          alarms, [this](const PathStep& step) { return compensate(step); },
          [this](const motion::Motion& motion) { pass(motion); }),
      compensation_(alarms, outlet_, settings),
      tip_(axes.start) {
  compensation_.set_tip(tip_);
}

bool Toolpath::end_block() {
  if (!end_block_of_corner()) return false;
  if (!compensation_.active()) return true;
  if (ending_ && !moved_in_plane_) {
    compensation_.end();
    ending_ = false;
    return !alarms_.alarm();
  }
  if (moved_in_plane_) return true;
  const bool good = compensation_.idle_block();
  gave_up_corner_ = compensation_.gave_up_corner();
  return good;
}

// Behind a line that waits nothing else does.
bool Toolpath::end_block_of_corner() {
  if (!unfinished_) return corners_.end_block();
  if (++unfinished_->idle_blocks <= CornerRounding::kMostIdleBlocks) return true;
  const base::Place place = unfinished_->place;
  unfinished_.reset();
  return alarms_.raise_at(base::Code::drawing_format, place,
                          "more than one block without a move behind an angle");
}

bool Toolpath::await_end(double angle_deg, const motion::Feed& feed) {
  if (unfinished_) return refuse_unfinished();
  unfinished_ = {.angle_deg = angle_deg,
                 .feed = feed,
                 .block = block_,
                 .place = alarms_.place(),
                 .rules = rules_,
                 .corner = corner_at_end_};
  moved_in_plane_ = true;
  return true;
}

bool Toolpath::finish_line(const PathPoint& from, const PathPoint& to) {
  UnfinishedLine line = *std::exchange(unfinished_, std::nullopt);
  std::swap(block_, line.block);
  std::swap(rules_, line.rules);
  std::swap(corner_at_end_, line.corner);
  const bool good = move(from, make(motion::Line{on_path(to), line.feed}), nullptr, &line.place);
  std::swap(block_, line.block);
  std::swap(rules_, line.rules);
  std::swap(corner_at_end_, line.corner);
  if (!good) return false;
  for (const motion::Motion& motion : line.beside) act(motion);
  return true;
}

// The line behind an angle alone did not come.
bool Toolpath::refuse_unfinished() {
  unfinished_.reset();
  return alarms_.raise(base::Code::angle_alone);
}

void Toolpath::end_compensation(std::optional<geometry::Vec2> wall) {
  ending_ = true;
  wall_ = wall;
}

bool Toolpath::interrupt_compensation() {
  if (unfinished_) return refuse_unfinished();
  return corners_.refuse_other_move() && (!compensation_.active() || compensation_.interrupt());
}

std::optional<Toolpath::Paused> Toolpath::pause_compensation() {
  if (!compensation_.active()) return std::nullopt;
  const Paused paused{compensation_.plane(), compensation_.cutter()};
  go_back_to(compensation_.tip());
  return ending_ ? std::nullopt : std::optional(paused);
}

void Toolpath::go_back_to(const TipPoint& tip) {
  unfinished_.reset();
  corners_.reset();
  compensation_.reset();
  put_tip(tip);
}

void Toolpath::stand_at(const TipPoint& tip) {
  if (surface() != nullptr) outlet_.begin(*surface(), tip);
  put_tip(surface() != nullptr ? outlet_.in_plane(tip) : tip);
}

void Toolpath::enter(const motion::Surface& surface) {
  outlet_.begin(surface, tip());
  put_tip(outlet_.in_plane(tip()));
}

void Toolpath::leave_surface() {
  put_tip(outlet_.on_machine());
  outlet_.end();
}

bool Toolpath::release() {
  const bool complete = !unfinished_ || refuse_unfinished();
  // What waits before it is made all the same.
  return corners_.refuse() && (!compensation_.active() || compensation_.release()) && complete;
}

void Toolpath::reset() {
  outlet_.reset();
  tip_ = tip();
  unfinished_.reset();
  corners_.reset();
  compensation_.reset();
  compensation_.set_tip(tip_);
}

TipPoint Toolpath::tip() const {
  if (corners_.holding()) return *motion::target_of(corners_.held().motion);
  return compensation_.active() ? compensation_.tip() : tip_;
}

bool Toolpath::arc(const PathPoint& from, const PathPoint& to, const ArcShape& shape,
                   const motion::Feed& feed) {
  return move(from, arc_along(on_path(to), shape, feed), &shape);
}

bool Toolpath::straight(const motion::Motion& motion) {
  if (!interrupt_compensation()) return false;
  if (compensation_.active()) tip_ = compensation_.tip();
  return emit(motion);
}

void Toolpath::act(const motion::Motion& motion) {
  if (unfinished_) {
    unfinished_->beside.push_back(motion);
  } else if (corners_.holding()) {
    corners_.beside(motion);
  } else {
    pass(motion);
  }
}

// What is no move in the plane keeps its place among the moves.
bool Toolpath::pass(const motion::Motion& motion) {
  return compensation_.active() ? compensation_.beside(motion) : emit(motion);
}

// Most moves meet neither a corner nor compensation.
bool Toolpath::move(const PathPoint& from, const motion::Motion& motion, const ArcShape* shape,
                    const base::Place* place) {
  if (unfinished_) return refuse_unfinished();
  const bool rounds = corner_at_end_.has_value() || corners_.holding();
  if (!compensation_.active() && !rounds) return emit(motion);
  const motion::PlaneAxes plane = compensation_.active() ? compensation_.plane()
                                  : corner_at_end_       ? corner_at_end_->axes
                                                         : corners_.axes();
  const TipPoint& to = *motion::target_of(motion);
  PathStep step{.motion = motion,
                .piece = {.from = plane.project(from), .to = plane.project(to)},
                .every_part_stops = rules_.every_cut_stops && motion::is_cut(motion)};
  if (shape != nullptr) {
    step.piece.is_arc = true;
    step.piece.clockwise = shape->direction == motion::Direction::clockwise;
    step.piece.centre = shape->centre;
  }
  if (shape == nullptr && step.piece.from == step.piece.to) return move_beside_plane(motion);
  moved_in_plane_ = true;
  step.place = place != nullptr ? *place : alarms_.place();
  return rounds ? round(step) : compensate(step);
}

bool Toolpath::move_beside_plane(const motion::Motion& motion) {
  if (corner_at_end_)
    return alarms_.raise(base::Code::corner_missing_move, "this block does not move in the plane");
  return corners_.refuse() && pass(motion);
}

bool Toolpath::round(const PathStep& step) {
  if (!corner_at_end_) return corners_.move(step, corners_.plane(), corners_.axes(), std::nullopt);
  if (ending_ || compensation_.starting()) {
    return alarms_.raise_at(base::Code::corner_in_compensation, step.place);
  }
  return corners_.move(step, corner_at_end_->plane, corner_at_end_->axes, corner_at_end_->request);
}

bool Toolpath::compensate(const PathStep& step) {
  if (!compensation_.active()) return emit(step.motion, &step.place);
  const bool good = ending_ ? compensation_.end_with(step, wall_) : compensation_.move(step);
  if (!compensation_.active()) tip_ = compensation_.tip();
  return good;
}

// A rapid or line that goes nowhere is no motion; an arc that ends where it begins is a full
// circle.
bool Toolpath::emit(const motion::Motion& motion, const base::Place* place) {
  const TipPoint* const to = motion::target_of(motion);
  const bool straight_line = std::holds_alternative<motion::Rapid>(motion.action) ||
                             std::holds_alternative<motion::Line>(motion.action);
  if (straight_line && *to == tip_) return true;
  if (!outlet_.let_out(motion, tip_, place)) return false;
  if (to == nullptr) return true;
  tip_ = *to;
  compensation_.set_tip(tip_);
  return true;
}

}  // namespace kerf::control
