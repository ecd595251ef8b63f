#pragma once

#include <deque>
#include <mutex>
#include <vector>

#include "motion/motion_end_sink.hpp"
#include "stock/cutting/motion_cut.hpp"

namespace kerf::stock {

/// Brings together what motions cut and when the planner has them end: each comes from its own
/// side, in the order of the motions, and the later one hands them on. What waits is what one side
/// is ahead by. The times may come from another thread; what is handed on is on the caller's of
/// take() and finish().
class CutClock final : public motion::MotionEndSink, public MotionCutSink {
 public:
  void add_sink(TimedCutSink& sink) { sinks_.push_back(&sink); }

  void motion_ends(std::uint64_t motion, double time_s) override;
  void take(const MotionCut& cut) override;
  /// The run is over, and lasted so long: what has no end of its own ended with it.
  void finish(double time_s);

 private:
  struct End {
    std::uint64_t motion;
    double time_s;
  };

  void fetch();
  void join();
  void hand_on(const MotionCut& cut, double end_s);

  std::vector<TimedCutSink*> sinks_;
  std::deque<MotionCut> waiting_;
  std::deque<End> ends_;
  double last_s_ = 0;  // when the motion before ended
  std::mutex mutex_;   // of what follows
  std::vector<End> told_;
};

}  // namespace kerf::stock
