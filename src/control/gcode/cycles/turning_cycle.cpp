#include "control/gcode/cycles/turning_cycle.hpp"

#include <algorithm>
#include <utility>

namespace kerf::control {
namespace {

using base::PathPoint;
using Kind = TurningMove::Kind;

}  // namespace

bool TurningCycle::plane(motion::PlaneAxes& axes) {
  const auto found = motion::plane_axes(motion::Plane::zx, state_.axes);
  if (!found)
    return state_.alarms.raise(base::Code::illegal_plane_axis, "a cycle turns in Z and X");
  if (state_.modal.plane() != motion::Plane::zx)
    return state_.alarms.raise(base::Code::cycle_state, "the plane is not ZX");
  axes = *found;
  return true;
}

void TurningCycle::begin(Meaning cycle, std::unique_ptr<TurningPasses> passes,
                         const motion::PlaneAxes& axes, Manner manner) {
  if (!manner.repeats) state_.count_cycle(cycle);
  passes_ = std::move(passes);
  axes_ = axes;
  manner_ = std::move(manner);
  moves_.apply_length(static_cast<base::AxisSet>(base::only(axes.first) | base::only(axes.second)));
}

bool TurningCycle::step() {
  TurningMove move;
  if (passes_->next(move)) return make(move);
  state_.cycles.add(std::max<std::uint64_t>(passes_->passes(), 1));
  passes_ = nullptr;
  return true;
}

// A move along the shape belongs to the block of the shape.
bool TurningCycle::make(const TurningMove& move) {
  PathPoint to = state_.coordinates.path();
  axes_.place(to, move.to);
  if (!moves_.check_limits(to)) return false;
  const base::BlockId own = state_.path.block();
  if (move.block < manner_.blocks.size()) state_.path.stand_in(manner_.blocks[move.block]);
  const bool good = emit(move, to);
  state_.path.stand_in(own);
  if (good) state_.coordinates.arrive_at(to);
  state_.moved_since_m29 = true;
  return good;
}

// The contour of a move with the nose is that of the programmed points.
bool TurningCycle::emit_with_nose(const TurningMove& move, const PathPoint& to) {
  const PathPoint& from = state_.coordinates.path();
  if (move.kind == Kind::rapid) return state_.path.move(from, state_.rapid(on_path(to)));
  return state_.path.move(from, motion::Line{on_path(to), manner_.feed});
}

bool TurningCycle::emit(const TurningMove& move, const PathPoint& to) {
  if (move.has_nose && state_.path.compensating()) return emit_with_nose(move, to);
  const base::TipPoint tip = on_path(to);
  if (move.kind == Kind::rapid) return state_.path.straight(state_.rapid(tip));
  if (move.kind == Kind::thread) {
    const motion::Thread cut{.to = tip, .lead = manner_.lead, .depth_mm = manner_.height};
    return moves_.can_follow_spindle(cut) && state_.path.straight(cut);
  }
  if (!move.is_arc) return state_.path.straight(motion::Line{tip, manner_.feed});
  return state_.path.straight(motion::Arc{.to = tip,
                                          .center = {move.centre.u, move.centre.v},
                                          .feed = manner_.feed,
                                          .plane = motion::Plane::zx,
                                          .direction = move.clockwise
                                                           ? motion::Direction::clockwise
                                                           : motion::Direction::counterclockwise});
}

}  // namespace kerf::control
