#include "motion/interpolator.hpp"

#include <cmath>

namespace kerf::motion {
namespace {

std::array<bool, base::kMaxAxes> linear_axes(const control::AxisSetup& axes) {
  std::array<bool, base::kMaxAxes> linear{};
  for (std::size_t m = 0; m < axes.count(); ++m) linear[m] = !axes.axes[m].rotary;
  return linear;
}

// A standstill this little behind a period belongs to it: rounding of the sums of durations.
constexpr double kSameTick = 1e-9;

}  // namespace

Interpolator::Interpolator(const control::AxisSetup& axes, const AxisLimits& limits,
                           const Settings& settings)
    : axes_(axes),
      settings_(settings),
      limits_(limits, settings, axes.count(), linear_axes(axes)),
      builder_(axes_, limits_, settings_, path_),
      look_ahead_(limits_.jerk_limited()) {}

void Interpolator::take(const control::Motion& motion) {
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
    look_ahead_.absorb(path_.cells);
    if (look_ahead_.empty() || (!ended_ && room())) return false;
    look_ahead_.plan(ended_);
    if (!look_ahead_.has_planned()) return false;
  }
  section_ = look_ahead_.take();
  if (section_.dwell_s == 0)
    profile_ = Profile(section_.length, section_.entry, section_.exit, section_.limits);
  phase_ = 0;
  phase_way_ = 0;
  cell_way_ = 0;
  cells_left_ = section_.cells;
  driving_ = true;
  return true;
}

std::uint64_t Interpolator::ticks_until(double time_s) const {
  return static_cast<std::uint64_t>(std::ceil(time_s / settings_.period_s - kSameTick));
}

// Behind the last cell of a section_.
void Interpolator::end_section() {
  for (; cells_left_ > 0; --cells_left_) path_.cells.pop();
  driving_ = false;
}

void Interpolator::pop_marks(double at) {
  const std::uint64_t cell = path_.cells.begin();
  while (!path_.marks.empty()) {
    const PathMark& mark = path_.marks.front();
    if (mark.cell > cell || (mark.cell == cell && mark.way >= at)) break;
    path_.marks.pop();
  }
}

void Interpolator::advance_cell(double way) {
  while (cells_left_ > 1 && way > cell_way_ + path_.cells.front().length()) {
    cell_way_ += path_.cells.front().length();
    path_.cells.pop();
    --cells_left_;
  }
}

void Interpolator::fill(Setpoint& point, double way) {
  advance_cell(way);
  const Cell& cell = path_.cells.front();
  const double at = std::min(cell.end, cell.begin + (way - cell_way_));
  point.time_s = time_s();
  point.tip = cell.curve.at(at);
  pop_marks(at);
  if (!path_.marks.empty()) point.mark = path_.marks.front().mark;
}

void Interpolator::end_phase(const Phase& phase) {
  phase_way_ += phase.way(phase.duration_s);
  phase_late_s_ += phase.duration_s;
  const double whole = std::floor(phase_late_s_ / settings_.period_s);
  phase_tick_ += static_cast<std::uint64_t>(whole);
  phase_late_s_ -= whole * settings_.period_s;
  ++phase_;
}

// The axes rest; what follows begins at this period.
void Interpolator::stop_at(std::uint64_t tick) {
  tick_ = phase_tick_ = tick;
  phase_late_s_ = 0;
}

bool Interpolator::next(Setpoint& point) {
  for (;;) {
    if (!driving_ && !load_section()) return false;
    if (section_.dwell_s > 0) {
      ++tick_;
      fill(point, 0);
      if (tick_ >= phase_tick_ + ticks_until(section_.dwell_s)) {
        stop_at(tick_);
        end_section();
      }
      return true;
    }
    const auto phases = profile_.phases();
    for (; phase_ < phases.size(); end_phase(phases[phase_])) {
      const double t =
          static_cast<double>(tick_ + 1 - phase_tick_) * settings_.period_s - phase_late_s_;
      if (t >= phases[phase_].duration_s) continue;
      ++tick_;
      fill(point, phase_way_ + phases[phase_].way(t));
      return true;
    }
    if (!section_.stop) {
      end_section();
      continue;
    }
    stop_at(std::max(tick_, phase_tick_ + ticks_until(phase_late_s_)));
    fill(point, 2 * section_.length);
    end_section();
    return true;
  }
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

}  // namespace kerf::motion
