#include "planner/operator_wishes.hpp"

#include <optional>
#include <utility>

namespace kerf::planner {

void OperatorWishes::hold() {
  wants_hold_ = true;
  wants_whole_block_ = false;
}

void OperatorWishes::hold_behind_block() {
  if (wants_hold_) return;
  wants_hold_ = wants_whole_block_ = true;
  constexpr std::uint64_t kAnyMotion = ~std::uint64_t{0};
  behind_motion_ = drive_.standing() ? drive_.mark().motion : kAnyMotion;
}

void OperatorWishes::reset() {
  wants_hold_ = wants_reset_ = true;
  wants_whole_block_ = false;
  if (held_) forget_ahead();
}

void OperatorWishes::resume() {
  wants_hold_ = wants_reset_ = wants_whole_block_ = false;
  if (!held_) return;
  held_ = at_reset_ = false;
  ahead_.begin_at_rest(drive_.offset());
}

void OperatorWishes::forget_ahead() {
  ahead_.forget(drive_.tip());
  drive_.leave_at(0);
  wants_reset_ = false;
  at_reset_ = true;
}

void OperatorWishes::try_to_grant() {
  if (!held_ && !drive_.driving() && !drive_.standing()) return;  // starved on the way
  if (wants_hold_ && !wants_reset_ && drive_.driving() && ahead_.is_in_thread()) return;
  const bool at_rest = held_ || !drive_.driving();
  if (at_rest && wants_hold_ && (!wants_whole_block_ || held_ || block_is_over()))
    return grant_at_rest();
  if (drive_.dwelling()) return grant_in_dwell();
  const PathState from = drive_.now();
  if (from.acceleration == 0 || !ahead_.limits.jerk_limited()) {
    if (replan(from)) drive_.leave_at(from.offset);
    return;
  }
  const auto leveling = replanner_.level_off(from);
  if (!leveling || !replan(leveling->behind)) return;
  drive_.leave_at(from.offset);
  drive_.begin(leveling->section, leveling->profile);
}

void OperatorWishes::grant_at_rest() {
  replanner_.override_cells(ahead_.cells.begin(), wanted_);
  overrides_ = wanted_;
  if (!held_) come_to_rest();
}

// What remains of the dwell follows when the feed goes on.
void OperatorWishes::grant_in_dwell() {
  if (!wants_hold_ || wants_whole_block_) return;
  drive_.break_dwell();
  overrides_ = wanted_;
  come_to_rest();
}

bool OperatorWishes::replan(const PathState& from) {
  if (!make_plan(from)) return false;
  stopping_ = wants_hold_;
  replanner_.adopt();
  return true;
}

bool OperatorWishes::make_plan(const PathState& from) {
  if (wants_hold_)
    return wants_whole_block_ ? replanner_.to_block_end(from) : replanner_.to_rest(from);
  if (!replanner_.to_overrides(from, wanted_)) return false;
  overrides_ = wanted_;
  return true;
}

// At rest: nothing of the block of the last point follows.
bool OperatorWishes::block_is_over() const {
  return drive_.mark().motion != behind_motion_ &&
         replanner_.is_over(drive_.mark(), drive_.offset());
}

void OperatorWishes::come_to_rest() {
  const bool planned = std::exchange(stopping_, false);
  if (planned && !wants_hold_) ahead_.begin_at_rest(drive_.offset());
  if (!wants_hold_ || (wants_whole_block_ && !planned && !block_is_over())) return;
  held_ = true;
  if (wants_reset_) forget_ahead();
}

}  // namespace kerf::planner
