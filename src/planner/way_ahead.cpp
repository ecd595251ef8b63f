#include "planner/way_ahead.hpp"

namespace kerf::planner {
namespace {

std::size_t driven_axes(const motion::AxisSetup& axes, const Linkage* linkage) {
  return linkage == nullptr ? axes.count() : linkage->size();
}

}  // namespace

WayAhead::WayAhead(const motion::AxisSetup& axis_setup, const AxisLimits& axis_limits,
                   const Settings& settings, const Linkage* linkage)
    : axes(axis_setup),
      limits(axis_limits, settings, driven_axes(axes, linkage), motion::linear_axes(axes)),
      builder(axes, limits, settings, path, linkage),
      maker(limits, linkage),
      plan(limits.jerk_limited()) {}

void WayAhead::take(const motion::Motion& motion) {
  ended = false;
  builder.take(motion);
}

void WayAhead::finish() {
  builder.stop();
  ended = true;
}

bool WayAhead::next_section(const Overrides& overrides, Section& section) {
  if (!plan.has_planned()) {
    maker.make(path, overrides, cells);
    plan.absorb(cells);
    if (plan.empty() || (!ended && builder.room())) return false;
    if (!plan.plan(is_seen_to_its_end(plan)) || !plan.has_planned()) return false;
  }
  plan.take(section);
  return true;
}

void WayAhead::leave_cell() {
  cells.pop();
  const std::uint64_t next = cells.empty() ? maker.next_piece() : cells.front().piece;
  while (path.pieces.begin() < next) path.pieces.pop();
}

void WayAhead::leave_marks(double at) {
  const std::uint64_t piece = path.pieces.begin();
  while (!path.marks.empty()) {
    const PathMark& mark = path.marks.front();
    if (mark.piece > piece || (mark.piece == piece && mark.way >= at)) break;
    path.marks.pop();
  }
}

void WayAhead::forget(const base::TipPoint& tip) {
  builder.clear(tip);
  path.marks.clear();
  cells.clear();
  path.pieces.clear();
  maker.skip_to(path);
  begin_at_rest(0);
}

}  // namespace kerf::planner
