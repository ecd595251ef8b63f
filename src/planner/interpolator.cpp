#include "planner/interpolator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "motion/axis_norms.hpp"

namespace kerf::planner {
namespace {

std::size_t driven_axes(const motion::AxisSetup& axes, const Linkage* linkage) {
  return linkage == nullptr ? axes.count() : linkage->size();
}

// Ages would not fit into the counter of periods.
std::uint64_t whole_periods(double periods) {
  constexpr double kMost = 1e17;
  return static_cast<std::uint64_t>(std::min(periods, kMost));
}

// A standstill this little behind a period belongs to it: rounding of the sums of durations.
constexpr double kSameTick = 1e-9;

}  // namespace

Interpolator::Interpolator(const motion::AxisSetup& axes, const AxisLimits& limits,
                           const Settings& settings, const Linkage* linkage)
    : axes_(axes),
      settings_(settings),
      limits_(limits, settings, driven_axes(axes, linkage), motion::linear_axes(axes)),
      builder_(axes_, limits_, settings_, path_, linkage),
      maker_(limits_, linkage),
      look_ahead_(limits_.jerk_limited()),
      trial_(limits_.jerk_limited()),
      tip_(axes.start) {}

void Interpolator::take(const motion::Motion& motion) {
  ended_ = false;
  builder_.take(motion);
}

void Interpolator::finish() {
  builder_.stop();
  ended_ = true;
}

// Makes the next section the one under way. False when what is known of the path is not enough.
bool Interpolator::load_section() {
  if (!look_ahead_.has_planned()) {
    maker_.make(path_, overrides_, cells_);
    look_ahead_.absorb(cells_);
    if (look_ahead_.empty() || (!ended_ && room())) return false;
    if (!look_ahead_.plan(ended_) || !look_ahead_.has_planned()) return false;
  }
  section_ = look_ahead_.take();
  if (section_.dwell_s == 0)
    profile_ = Profile(section_.length, section_.entry, section_.exit, section_.limits);
  begin_section();
  return true;
}

void Interpolator::begin_section() {
  phase_ = 0;
  phase_way_ = 0;
  cell_way_ = -offset_;
  cells_left_ = section_.cells;
  driving_ = true;
  if (section_.dwell_s == 0) standing_ = false;
}

void Interpolator::end_section() {
  for (; cells_left_ > 0; --cells_left_) pop_cell();
  offset_ = section_.tail;
  driving_ = false;
}

void Interpolator::end_phase(const Phase& phase) {
  phase_way_ += phase.way(phase.duration_s);
  phase_late_s_ += phase.duration_s;
  const double whole = std::floor(phase_late_s_ / settings_.period_s);
  phase_tick_ += whole_periods(whole);
  phase_late_s_ = std::max(0.0, phase_late_s_ - whole * settings_.period_s);
  ++phase_;
}

std::uint64_t Interpolator::ticks_until(double time_s) const {
  return whole_periods(std::ceil(time_s / settings_.period_s - kSameTick));
}

// The axes rest; what follows begins at this period.
void Interpolator::stop_at(std::uint64_t tick) {
  tick_ = phase_tick_ = tick;
  phase_late_s_ = 0;
}

void Interpolator::pop_cell() {
  cells_.pop();
  const std::uint64_t next = cells_.empty() ? maker_.next_piece() : cells_.front().piece;
  while (path_.pieces.begin() < next) path_.pieces.pop();
}

void Interpolator::advance_cell(double way) {
  while (cells_left_ > 0 && way > cell_way_ + cells_.front().length()) {
    if (cells_left_ == 1 && section_.tail == 0) return;  // the end belongs to the last one
    cell_way_ += cells_.front().length();
    pop_cell();
    --cells_left_;
  }
}

void Interpolator::pop_marks(double at) {
  const std::uint64_t piece = path_.pieces.begin();
  while (!path_.marks.empty()) {
    const PathMark& mark = path_.marks.front();
    if (mark.piece > piece || (mark.piece == piece && mark.way >= at)) break;
    path_.marks.pop();
  }
}

void Interpolator::fill(motion::Setpoint& point, double way) {
  advance_cell(way);
  const Cell& cell = cells_.front();
  const double at = std::min(cell.end, cell.begin + (way - cell_way_));
  tip_ = path_.pieces.front().curve.at(at);
  pop_marks(at);
  if (!path_.marks.empty()) mark_ = path_.marks.front().mark;
  point = {time_s(), tip_, mark_};
}

// A period of the dwell under way.
bool Interpolator::dwelling(motion::Setpoint& point) {
  if (section_.dwell_s == 0) return false;
  ++tick_;
  pop_marks(0);
  if (!path_.marks.empty()) mark_ = path_.marks.front().mark;
  point = {time_s(), tip_, mark_};
  if (tick_ >= phase_tick_ + ticks_until(section_.dwell_s)) {
    stop_at(tick_);
    end_section();
    end_standstill();
  }
  return true;
}

bool Interpolator::next(motion::Setpoint& point) {
  if (has_wish()) grant_wish();
  if (held_) {
    stop_at(tick_ + 1);
    point = {time_s(), tip_, mark_};
    return true;
  }
  for (;;) {
    if (!driving_ && !load_section()) return false;
    if (dwelling(point)) return true;
    const auto phases = profile_.phases();
    for (; phase_ < phases.size(); end_phase(phases[phase_])) {
      const double t =
          static_cast<double>(tick_ + 1 - phase_tick_) * settings_.period_s - phase_late_s_;
      const bool last = section_.stop && phase_ + 1 == phases.size();
      const double slack_s = last ? kSameTick * settings_.period_s : 0;
      if (t >= phases[phase_].duration_s - slack_s) continue;
      ++tick_;
      fill(point, phase_way_ + phases[phase_].way(t));
      return true;
    }
    if (section_.stop) break;
    end_section();
  }
  stop_at(std::max(tick_ + 1, phase_tick_ + ticks_until(phase_late_s_)));
  constexpr double kToTheEnd = std::numeric_limits<double>::infinity();
  fill(point, section_.tail == 0 ? kToTheEnd : section_.length);
  end_section();
  end_standstill();
  return true;
}

base::TipPoint Interpolator::motion_end() const {
  if (path_.marks.empty()) return tip_;
  const PathMark& mark = path_.marks[path_.marks.begin()];
  const bool known = path_.pieces.begin() <= mark.piece && mark.piece < path_.pieces.end();
  return known ? path_.pieces[mark.piece].curve.at(mark.way) : tip_;
}

// The axes have come to rest.
void Interpolator::end_standstill() {
  standing_ = true;
  const bool planned = std::exchange(stopping_, false);
  if (planned && !wants_hold_) look_ahead_.begin_at(cells_.begin(), offset_, 0);
  if (!wants_hold_ || (wants_whole_block_ && !planned && !block_is_over())) return;
  held_ = true;
  if (wants_reset_) drop();
}

void Interpolator::skip() {
  while (driving_ || load_section()) {
    if (section_.dwell_s > 0) {
      stop_at(phase_tick_ + ticks_until(section_.dwell_s));
    } else {
      while (phase_ < profile_.phases().size()) end_phase(profile_.phases()[phase_]);
      if (section_.stop) stop_at(phase_tick_ + ticks_until(phase_late_s_));
    }
    end_section();
    pop_marks(0);
  }
}

}  // namespace kerf::planner
