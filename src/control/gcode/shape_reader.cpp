#include "control/gcode/shape_reader.hpp"

#include <algorithm>
#include <utility>

#include "control/core/assumed.hpp"
#include "control/gcode/acts/compensation.hpp"
#include "control/gcode/cycles/shape_check.hpp"

namespace kerf::control {
namespace {

using base::Code;

// More is a loop that never comes to the last block.
constexpr std::size_t kMostPieces = 300000;

bool is_of_shape(const Words::G& g, bool has_nose) {
  switch (g.group()) {
    case Group::compensation: return !has_nose;
    case Group::one_shot: return g.meaning() == Meaning::dwell;
    case Group::motion:
      return g.meaning() == Meaning::rapid || g.meaning() == Meaning::line ||
             g.meaning() == Meaning::arc_clockwise || g.meaning() == Meaning::arc_counterclockwise;
    case Group::unit:
    case Group::cycle:
    case Group::modal_call: return false;
    default: return true;
  }
}

bool ends(Function function) {
  return function == Function::end || function == Function::end_and_rewind;
}

}  // namespace

bool admits_in_shape(State& state, const Targets& targets, const Words& words) {
  for (std::size_t i = 0; i < state.axes.count(); ++i) {
    const base::Axis axis{static_cast<std::uint8_t>(i)};
    const gcode::Word* const word = targets.word_of(words, axis);
    if (word != nullptr && state.axes[axis].letter != 'X' && state.axes[axis].letter != 'Z')
      return state.alarms.raise(Code::shape_command, word->text, "a shape lies in X and Z");
  }
  for (const Words::G* g = words.g_begin(); g != words.g_end(); ++g) {
    if (g->row != nullptr && !is_of_shape(*g, state.parameters.compensated_cycles))
      return state.alarms.raise(Code::shape_command, g->word->text);
  }
  for (const Words::M* m = words.m_begin(); m != words.m_end(); ++m) {
    if (is_call(m->function())) return state.alarms.raise(Code::call_in_shape, m->word->text);
    if (ends(m->function())) return state.alarms.raise(Code::shape_command, m->word->text);
  }
  return true;
}

bool ends_complete(State& state) {
  if (state.path.unfinished()) return state.alarms.raise(Code::shape_last_angle);
  return !state.path.holds_corner() || state.alarms.raise(Code::shape_last_block);
}

bool ShapeReader::begin(const motion::PlaneAxes& axes) {
  if (!state_.path.interrupt_compensation()) return false;
  axes_ = axes;
  kept_.emplace(Kept{state_.modal, state_.before, state_.words, state_.coordinates,
                     state_.wanted_offset, state_.path.block(), state_.path.tip(),
                     state_.path.pause_compensation()});
  has_nose_ = state_.parameters.compensated_cycles && kept_->compensation;
  if (state_.modal.compensating() && !state_.parameters.compensated_cycles)
    tell_rough_without_nose(state_);
  state_.modal.set(Meaning::compensation_off);
  state_.reads_shape = true;
  shape_ = {};
  blocks_.clear();
  at_ = shape_.start = axes.project(kept_->coordinates.path());
  in_first_ = awaits_first_ = true;
  buffer_.divert(this);
  return true;
}

bool ShapeReader::begins_straight(const Words& words) const {
  const Meaning motion = state_.modal[Group::motion];
  return (motion == Meaning::rapid || motion == Meaning::line) && words.has_any(targets_.letters());
}

bool ShapeReader::end_block(const Words& words) {
  if (shape_.pieces.size() > kMostPieces)
    return state_.alarms.raise(Code::shape_not_found, "the shape does not come to its last block");
  if (!in_first_) return true;
  in_first_ = false;
  if (!begins_straight(words)) return state_.alarms.raise(Code::shape_first_block);
  awaits_first_ = awaits_first_ && state_.path.holds_corner();  // its move is made behind it
  shape_.approach_is_rapid = state_.modal[Group::motion] == Meaning::rapid;
  shape_.both_axes = targets_.word_of(words, axes_.first) != nullptr &&
                     targets_.word_of(words, axes_.second) != nullptr;
  return true;
}

bool ShapeReader::end() {
  const bool good = ends_complete(state_) && (!has_nose_ || compensate());
  restore();
  return good;
}

// The contour goes through the compensation from the start on, where the tool has no offset, and
// ends perpendicular: what comes out takes its place.
bool ShapeReader::compensate() {
  const Toolpath::Paused& nose = *kept_->compensation;
  if (side_of_start(shape_) * nose.cutter.offset < 0)
    return state_.alarms.raise_at(Code::shape_side, base::place_of(kept_->cycle), kept_->cycle, "");
  if (shape_.pieces.empty()) return true;
  const TurningShape contour = shape_;
  const std::vector<base::BlockId> blocks = std::exchange(blocks_, {});
  shape_.pieces.clear();
  state_.path.go_back_to(on_path(kept_->coordinates.path()));
  state_.path.resume(nose);
  at_ = contour.start;
  const ShapePiece approach{.from = at_, .to = first_point(contour), .block = contour.first_block};
  awaits_first_ = approach.to != approach.from;
  if (awaits_first_ && !hand_on(approach, blocks)) return false;
  return std::all_of(contour.pieces.begin(), contour.pieces.end(),
                     [&](const ShapePiece& piece) { return hand_on(piece, blocks); }) &&
         state_.path.release();
}

bool ShapeReader::hand_on(const ShapePiece& piece, const std::vector<base::BlockId>& blocks) {
  base::PathPoint from = kept_->coordinates.path();
  base::PathPoint to = from;
  axes_.place(from, piece.from);
  axes_.place(to, piece.to);
  const base::BlockId& block = blocks[piece.block];
  if (!piece.is_arc) return state_.path.move_of(block, from, motion::Line{on_path(to), {}});
  const ArcShape shape{.plane = motion::Plane::zx,
                       .axes = axes_,
                       .centre = piece.centre,
                       .direction = piece.clockwise ? motion::Direction::clockwise
                                                    : motion::Direction::counterclockwise};
  return state_.path.move_of(block, from, arc_along(on_path(to), shape), &shape);
}

void ShapeReader::drop() {
  if (reading()) restore();
}

void ShapeReader::restore() {
  buffer_.divert(nullptr);
  state_.reads_shape = false;
  state_.path.go_back_to(kept_->tip);
  if (kept_->compensation) state_.path.resume(*kept_->compensation);
  state_.modal = kept_->modal;
  state_.before = kept_->before;
  state_.words = kept_->words;
  state_.coordinates = kept_->coordinates;
  state_.wanted_offset = kept_->wanted_offset;
  state_.refresh_format();
  kept_.reset();
}

void ShapeReader::take(const motion::Motion& motion) {
  if (motion::target_of(motion) != nullptr) return add(motion);
  state_.assume(Assumed::codes_of_shape,
                "dwells, spindle, tools and M codes of a shape mean nothing while it is roughed");
}

void ShapeReader::add(const motion::Motion& motion) {
  if (blocks_.empty() || blocks_.back() != motion.block) blocks_.push_back(motion.block);
  const auto block = static_cast<std::uint32_t>(blocks_.size() - 1);
  const geometry::Vec2 to = axes_.project(*motion::target_of(motion));
  ShapePiece piece{.from = at_, .to = to, .block = block};
  if (const auto* const arc = std::get_if<motion::Arc>(&motion.action)) {
    piece.is_arc = true;
    piece.clockwise = arc->direction == motion::Direction::clockwise;
    piece.centre = {arc->center[0], arc->center[1]};
  }
  at_ = to;
  if (awaits_first_) {
    awaits_first_ = false;
    shape_.first_block = block;
  } else {
    shape_.pieces.push_back(piece);
  }
}

}  // namespace kerf::control
