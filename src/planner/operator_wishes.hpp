#pragma once

#include <cstdint>

#include "planner/overrides.hpp"
#include "planner/replanner.hpp"
#include "planner/section_drive.hpp"
#include "planner/way_ahead.hpp"

namespace kerf::planner {

/// What the operator wishes, and when he gets it: feed hold, overrides and reset, as SetpointSource
/// has them.
///
/// A wish is granted before the next point, by a plan made anew. Where there is none the tool
/// follows the old plan for a period more, and the wish is tried again.
class OperatorWishes {
 public:
  /// Both must outlive this.
  OperatorWishes(WayAhead& ahead, SectionDrive& drive)
      : ahead_(ahead), drive_(drive), replanner_(ahead) {}

  void set_overrides(const Overrides& overrides) { wanted_ = overrides; }
  void hold();
  void hold_behind_block();
  void resume();
  void reset();
  [[nodiscard]] bool wants_hold() const { return wants_hold_; }
  [[nodiscard]] bool held() const { return held_; }
  [[nodiscard]] bool at_reset() const { return at_reset_; }
  /// Those in force: what is made from now on has them.
  [[nodiscard]] const Overrides& overrides() const { return overrides_; }

  /// Before each point.
  void grant() {
    if (any()) try_to_grant();
  }
  /// The axes have come to rest.
  void come_to_rest();

 private:
  [[nodiscard]] bool any() const {
    if (wants_hold_ && stopping_) return false;
    return wants_hold_ != (stopping_ || held_) || wanted_ != overrides_;
  }
  void try_to_grant();
  void grant_at_rest();
  void grant_in_dwell();
  [[nodiscard]] bool replan(const PathState& from);
  [[nodiscard]] bool make_plan(const PathState& from);
  [[nodiscard]] bool block_is_over() const;
  void forget_ahead();

  WayAhead& ahead_;
  SectionDrive& drive_;
  Replanner replanner_;
  Overrides overrides_;
  Overrides wanted_;
  bool wants_hold_ = false;
  bool wants_reset_ = false;
  bool wants_whole_block_ = false;   // the hold waits for the end of the block
  std::uint64_t behind_motion_ = 0;  // which is not that of this motion
  bool stopping_ = false;            // the plan ends in the hold
  bool held_ = false;
  bool at_reset_ = false;
};

}  // namespace kerf::planner
