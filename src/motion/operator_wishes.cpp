// Feed hold, overrides and reset: the plan is made anew from where the tool is.
//
// A new plan begins with the speed of the old one. The old one is always possible; so when the new
// one is not, because it asks for braking that can no longer be done, the tool follows the old one
// for a period more and the wish is tried again.
#include <algorithm>
#include <cmath>

#include "motion/interpolator.hpp"

namespace kerf::motion {

/// A stretch in which the acceleration goes to 0, and how the tool moves behind it.
struct Interpolator::Leveling {
  Profile profile;
  Section section;
  Motion behind;
};

void Interpolator::set_overrides(const Overrides& overrides) { wanted_ = overrides; }

void Interpolator::hold() { wants_hold_ = true; }

void Interpolator::reset() { wants_hold_ = wants_reset_ = true; }

void Interpolator::resume() {
  wants_hold_ = wants_reset_ = false;
  if (!held_) return;
  held_ = at_reset_ = false;
  look_ahead_.begin_at(cells_.begin(), offset_, 0);
}

// Everything ahead is forgotten.
void Interpolator::drop() {
  builder_.clear(tip_);
  path_.marks.clear();
  cells_.clear();
  path_.pieces.clear();
  maker_.skip_to(path_);
  offset_ = 0;
  look_ahead_.begin_at(cells_.begin(), 0, 0);
  wants_reset_ = false;
  at_reset_ = true;
}

// Where the tool is at the last point, and how it moves.
Interpolator::Motion Interpolator::now() const {
  Motion motion{cells_.begin(), offset_, 0, 0};
  if (!driving_ || phase_ >= profile_.phases().size()) return motion;
  const Phase& phase = profile_.phases()[phase_];
  const double t = static_cast<double>(tick_ - phase_tick_) * settings_.period_s - phase_late_s_;
  motion.offset = phase_way_ + phase.way(t) - cell_way_;
  motion.speed = phase.velocity_at(t);
  motion.acceleration = phase.acceleration_at(t);
  return motion;
}

void Interpolator::grant_wish() {
  const bool at_rest = held_ || !driving_;
  if (at_rest && wants_hold_) {
    try_overrides(cells_.begin());
    overrides_ = wanted_;
    if (!held_) end_standstill();
    return;
  }
  if (driving_ && section_.dwell_s > 0) return;
  const Motion from = now();
  if (from.acceleration == 0 || !limits_.jerk_limited()) {
    if (!replan(from)) return;
    offset_ = from.offset;
    driving_ = false;
  } else {
    Leveling leveling;
    if (!level_off(from, leveling) || !replan(leveling.behind)) return;
    offset_ = from.offset;
    section_ = leveling.section;
    profile_ = leveling.profile;
    begin_section();
  }
  stop_at(tick_);
}

bool Interpolator::replan(const Motion& from) {
  if (!(wants_hold_ ? replan_hold(from) : replan_overrides(from))) return false;
  stopping_ = wants_hold_;
  std::swap(look_ahead_, trial_);
  return true;
}

// With the jerk of the slowest cell that the stretch touches; which ones these are depends on the
// jerk in turn.
bool Interpolator::level_off(const Motion& from, Leveling& leveling) const {
  const double a = from.acceleration;
  const double side = a > 0 ? 1 : -1;
  double jerk = cells_[from.cell].limits.jerk;
  for (;;) {
    const Phase phase{std::fabs(a) / jerk, from.speed, a, -side * jerk};
    const double speed = phase.velocity_at(phase.duration_s);
    if (!(speed > 0)) return false;
    const double way = phase.way(phase.duration_s);
    Section section{way, {}, from.speed, speed, 0, from.offset + way, 0, false};
    double least = jerk;
    for (std::uint64_t n = from.cell;; ++n) {
      if (n >= cells_.end() || cells_[n].dwell_s > 0) return false;
      const PathLimits& limits = cells_[n].limits;
      constexpr double kSame = 1 - 1e-9;
      if (limits.velocity < std::max(from.speed, speed) * kSame) return false;
      if (limits.acceleration < std::fabs(a) * kSame) return false;
      least = std::min(least, limits.jerk);
      if (section.tail < cells_[n].length()) break;
      if (cells_[n].stop) return false;
      section.tail -= cells_[n].length();
      ++section.cells;
    }
    if (least == jerk) {
      leveling = {Profile(phase), section, {from.cell + section.cells, section.tail, speed, 0}};
      return true;
    }
    jerk = least;
  }
}

bool Interpolator::can_stop_within(const Motion& from, double way) {
  trial_.begin_at(from.cell, from.offset, from.speed);
  trial_.stop_after(way);
  trial_.absorb(cells_);
  return !trial_.empty() && trial_.plan(true);
}

// The shortest way to rest, to one part in a thousand.
bool Interpolator::replan_hold(const Motion& from) {
  double most = ramp_length(from.speed, 0, cells_[from.cell].limits);
  double least = 0;
  constexpr double kLongestWay = 1e6;
  for (; !can_stop_within(from, most); most *= 2) {
    if (most > kLongestWay) return false;
    least = most;
  }
  while (most - least > 1e-3 * most) {
    const double middle = least + (most - least) / 2;
    (can_stop_within(from, middle) ? most : least) = middle;
  }
  return can_stop_within(from, most);
}

// The cells that are nearest keep the limits that they had, as many as it takes to slow down to the
// new ones.
bool Interpolator::replan_overrides(const Motion& from) {
  for (std::uint64_t kept = 0;; kept = kept == 0 ? 1 : 2 * kept) {
    const std::uint64_t first = std::min(from.cell + kept, cells_.end());
    try_overrides(first);
    trial_.begin_at(from.cell, from.offset, from.speed);
    trial_.absorb(cells_);
    if (trial_.plan(ended_)) {
      overrides_ = wanted_;
      return true;
    }
    put_back_overrides(first);
    if (first == cells_.end()) return false;
  }
}

void Interpolator::try_overrides(std::uint64_t first) {
  for (std::uint64_t n = first; n < cells_.end(); ++n) {
    cells_[n].former_overrides = cells_[n].overrides;
    set_overrides_of(n, wanted_);
  }
}

// Not all cells have the same: those that an earlier change has left alone keep theirs.
void Interpolator::put_back_overrides(std::uint64_t first) {
  for (std::uint64_t n = first; n < cells_.end(); ++n)
    set_overrides_of(n, cells_[n].former_overrides);
}

void Interpolator::set_overrides_of(std::uint64_t cell, const Overrides& overrides) {
  Cell& c = cells_[cell];
  c.overrides = overrides;
  if (c.dwell_s == 0) c.limits = maker_.limits_of(c, path_.pieces[c.piece], overrides);
}

}  // namespace kerf::motion
