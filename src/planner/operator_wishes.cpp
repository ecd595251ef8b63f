// Feed hold, overrides and reset: the plan is made anew from where the tool is.
//
// A new plan begins with the speed of the old one. The old one is always possible; so when the new
// one is not, because it asks for braking that can no longer be done, the tool follows the old one
// for a period more and the wish is tried again.
#include <algorithm>
#include <cmath>

#include "planner/interpolator.hpp"

namespace kerf::planner {
namespace {

// Shorter than any motion, mm or degrees, and than any period.
constexpr double kSameWay = 1e-9;
constexpr double kSameTime_s = 1e-12;

bool same_block(const motion::Mark& a, const motion::Mark& b) {
  return a.line == b.line && a.file == b.file && a.program == b.program;
}

}  // namespace

/// A stretch in which the acceleration goes to 0, and how the tool moves behind it.
struct Interpolator::Leveling {
  Profile profile;
  Section section;
  Motion behind;
};

void Interpolator::set_overrides(const Overrides& overrides) { wanted_ = overrides; }

void Interpolator::hold() {
  wants_hold_ = true;
  wants_whole_block_ = false;
}

void Interpolator::hold_behind_block() {
  if (wants_hold_) return;
  wants_hold_ = wants_whole_block_ = true;
  constexpr std::uint64_t kAnyMotion = ~std::uint64_t{0};
  behind_motion_ = standing_ ? mark_.motion : kAnyMotion;
}

void Interpolator::reset() {
  wants_hold_ = wants_reset_ = true;
  wants_whole_block_ = false;
  if (held_) drop();
}

void Interpolator::resume() {
  wants_hold_ = wants_reset_ = wants_whole_block_ = false;
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
  if (!held_ && !driving_ && !standing_) return;  // starved on the way
  const bool at_rest = held_ || !driving_;
  if (at_rest && wants_hold_ && (!wants_whole_block_ || held_ || block_is_over())) {
    try_overrides(cells_.begin());
    overrides_ = wanted_;
    if (!held_) end_standstill();
    return;
  }
  if (driving_ && section_.dwell_s > 0) {
    if (wants_hold_ && !wants_whole_block_) interrupt_dwell();
    return;
  }
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
      // What RampLimits hold at the acceleration of now.
      const double most = std::max(speed, from.speed + a * a / (2 * limits.jerk));
      if (limits.velocity < most * kSame) return false;
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

// What remains of a dwell follows when the feed goes on.
void Interpolator::interrupt_dwell() {
  const double done_s = static_cast<double>(tick_ - phase_tick_) * settings_.period_s;
  cells_.front().dwell_s = std::max(section_.dwell_s - done_s, kSameTime_s);
  driving_ = false;
  overrides_ = wanted_;
  end_standstill();
}

// How far a mark is from a place on the way to it; nothing where the path is not known that far.
std::optional<double> Interpolator::way_to(const PathMark& mark, const Motion& from) const {
  double way = -from.offset;
  for (std::uint64_t n = from.cell; n < cells_.end(); ++n) {
    const Cell& cell = cells_[n];
    if (cell.piece > mark.piece) return way;
    if (cell.piece == mark.piece && mark.way <= cell.end)
      return way + std::max(0.0, mark.way - cell.begin);
    way += cell.length();
  }
  return std::nullopt;
}

bool Interpolator::ends_in_standstill(const PathMark& mark) const {
  if (mark.piece >= path_.pieces.end()) return false;
  const PathPiece& piece = path_.pieces[mark.piece];
  return piece.dwell_s > 0 || (piece.stop && mark.way >= piece.end - kSameWay);
}

// Where blocks end in a standstill the plan stays as it is: the hold comes there.
bool Interpolator::replan_to_block_end(const Motion& from) {
  for (std::uint64_t n = path_.marks.begin(); n < path_.marks.end(); ++n) {
    const PathMark& mark = path_.marks[n];
    if (n + 1 < path_.marks.end() && same_block(mark.mark, path_.marks[n + 1].mark)) continue;
    const std::optional<double> way = way_to(mark, from);
    if (!way || (*way > kSameWay && ends_in_standstill(mark))) return false;
    if (*way > kSameWay && can_stop_within(from, *way)) return true;
  }
  return false;
}

// At rest: nothing of the block of the last point follows.
bool Interpolator::block_is_over() const {
  if (mark_.motion == behind_motion_) return false;
  const Motion here{cells_.begin(), offset_, 0, 0};
  for (std::uint64_t n = path_.marks.begin(); n < path_.marks.end(); ++n) {
    const std::optional<double> way = way_to(path_.marks[n], here);
    if (!way || *way > kSameWay) return !same_block(path_.marks[n].mark, mark_);
  }
  return true;
}

bool Interpolator::can_stop_within(const Motion& from, double way) {
  trial_.begin_at(from.cell, from.offset, from.speed);
  trial_.stop_after(way);
  trial_.absorb(cells_);
  return !trial_.empty() && trial_.plan(true);
}

// The shortest way to rest, to one part in a thousand.
bool Interpolator::replan_hold(const Motion& from) {
  if (wants_whole_block_) return replan_to_block_end(from);
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

}  // namespace kerf::planner
