#pragma once

#include <cstdint>

#include "motion/motion_end_sink.hpp"
#include "planner/profile.hpp"
#include "planner/way_ahead.hpp"

namespace kerf::planner {

class PhaseWalk;

/// Says when the motions on the path end, as each section of it begins: its profile tells when any
/// place of it is passed. What an operator changes within a section comes too late for that.
class MotionEnds {
 public:
  void set_sink(motion::MotionEndSink& sink) { sink_ = &sink; }
  [[nodiscard]] bool is_wanted() const { return sink_ != nullptr; }

  /// A section that begins at `begin_s`, `offset` behind the begin of the first cell ahead. A dwell
  /// has a profile that is not looked at.
  void tell(const WayAhead& ahead, const Section& section, double offset, const Profile& profile,
            double begin_s);

 private:
  void tell_cell(const WayAhead& ahead, const Cell& cell, double last, double cell_way,
                 PhaseWalk& walk);
  void tell(const motion::Mark& mark, double time_s);

  motion::MotionEndSink* sink_ = nullptr;
  std::uint64_t next_ = 0;  // number of the first mark that is not told
  double last_s_ = 0;
};

}  // namespace kerf::planner
