#include "job/drawing/made_meter.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/arc.hpp"
#include "motion/feed.hpp"
#include "motion/motion_extent.hpp"
#include "motion/space_arc_path.hpp"

namespace kerf::job {
namespace {

using motion::Motion;

double distance(const motion::AxisSetup& axes, const base::TipPoint& from,
                const base::TipPoint& to) {
  double square = 0;
  for (const char letter : {'X', 'Y', 'Z'}) {
    const auto axis = axes.find(letter);
    if (!axis) continue;
    const double way = to[*axis] - from[*axis];
    square += way * way;
  }
  return std::sqrt(square);
}

double way_of(const motion::AxisSetup& axes, const base::TipPoint& from, const Motion& motion) {
  if (const auto* arc = std::get_if<motion::Arc>(&motion.action)) {
    const base::Axis x = *axes.find('X');
    const base::Axis y = *axes.find('Y');
    return geometry::arc_length({from[x], from[y]}, {arc->to[x], arc->to[y]},
                                {arc->center[0], arc->center[1]},
                                arc->direction == motion::Direction::clockwise, arc->turns, 0);
  }
  if (const auto* arc = std::get_if<motion::SpaceArc>(&motion.action)) {
    const motion::SpaceArcPath path(axes, from, *arc);
    return path.circle().radius() * path.circle().sweep_rad();
  }
  return distance(axes, from, *motion::target_of(motion));
}

/// 0: it has none.
template <typename Action>
double feed_of_action(const Action& action) {
  if constexpr (requires { action.feed.value; }) return action.feed.value;
  return 0;
}

double feed_of(const Motion& motion) {
  return std::visit([](const auto& action) { return feed_of_action(action); }, motion.action);
}

}  // namespace

MadeMeter::MadeMeter(const process::Plan& plan, const drawing::Drawing& drawing)
    : plan_(plan),
      reader_(plan, drawing),
      at_(plan.machine.axes.start),
      by_operation_(std::max<std::size_t>(1, plan.operations.size())) {}

/// Which operation the next motion is of.
void MadeMeter::follow_plan() {
  while (true) {
    if (next_step_ >= steps_.size()) {
      steps_.clear();
      next_step_ = 0;
      if (!reader_.next(steps_)) return;
      continue;
    }
    const process::Step& step = steps_[next_step_++];
    if (std::holds_alternative<Motion>(step)) return;
    operation_ = std::get<process::PassBegins>(step).operation;
  }
}

void MadeMeter::reach(const Motion& motion, output::Made& made) const {
  motion::MotionExtent extent = motion::extent_of(plan_.machine.axes, at_, motion);
  extent.reach(at_);
  output::Made more;
  more.low = extent.low;
  more.high = extent.high;
  more.has_extents = true;
  made.add(more);
}

void MadeMeter::measure_move(const Motion& motion, output::Made& made) {
  const motion::AxisSetup& axes = plan_.machine.axes;
  const double way = way_of(axes, at_, motion);
  const double beam_percent = power_.beam_percent();
  const bool cuts = beam_percent > 0 || !plan_.machine.has_beam || plan_.machine.makes_patterns;
  if (std::holds_alternative<motion::Rapid>(motion.action)) {
    made.travel_mm += way;
  } else if (cuts) {
    made.beam_mm += way;
    reach(motion, made);
    if (power_.follows_speed) {
      const double speed = feed_of(motion) / motion::kSecondsPerMinute;
      made.energy_j += plan_.machine.max_power_w * beam_percent / 100 * way / speed;
    }
  } else {
    made.overscan_mm += way;
  }
  at_ = *motion::target_of(motion);
}

/// As long as it is told to, whatever the period of the interpolator.
void MadeMeter::burn(const motion::Dwell& dwell, output::Made& made) const {
  ++made.pierces;
  made.beam_s += dwell.seconds;
  made.energy_j += plan_.machine.max_power_w * power_.beam_percent() / 100 * dwell.seconds;
}

void MadeMeter::take(const Motion& motion) {
  follow_plan();
  ++taken_;
  output::Made& made = by_operation_[operation_];
  if (const auto* power = std::get_if<motion::Power>(&motion.action)) power_ = *power;
  const bool is_lit = power_.beam_percent() > 0;
  const bool rests = std::holds_alternative<motion::Dwell>(motion.action);
  if (rests && is_lit) burn(std::get<motion::Dwell>(motion.action), made);
  const bool moves = motion::target_of(motion) != nullptr;
  if (moves) measure_move(motion, made);
  if (!moves && !rests) return;
  const double watts = plan_.machine.max_power_w * power_.beam_percent() / 100;
  const std::scoped_lock locked(lock_);
  const bool is_counted = rests || power_.follows_speed;
  pending_.push_back({taken_, operation_, is_counted ? 0 : watts, is_lit && !rests});
}

void MadeMeter::motion_ends(std::uint64_t motion, double time_s) {
  const std::scoped_lock locked(lock_);
  while (!pending_.empty() && pending_.front().number < motion) pending_.pop_front();
  if (pending_.empty() || pending_.front().number != motion) return;
  const Pending& done = pending_.front();
  output::Made& made = by_operation_[done.operation];
  const double lasted = time_s - last_s_;
  made.time_s += lasted;
  if (done.has_beam) made.beam_s += lasted;
  made.energy_j += done.power_w * lasted;
  last_s_ = time_s;
  pending_.pop_front();
}

output::Made MadeMeter::all() const {
  output::Made sum;
  for (const output::Made& made : by_operation_) sum.add(made);
  return sum;
}

}  // namespace kerf::job
