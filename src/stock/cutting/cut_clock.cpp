#include "stock/cutting/cut_clock.hpp"

#include <algorithm>

namespace kerf::stock {

void CutClock::motion_ends(std::uint64_t motion, double time_s) {
  const std::scoped_lock lock(mutex_);
  told_.push_back({motion, time_s});
}

void CutClock::take(const MotionCut& cut) {
  waiting_.push_back(cut);
  if (ends_.empty()) fetch();
  join();
}

void CutClock::finish(double time_s) {
  fetch();
  join();
  for (; !waiting_.empty(); waiting_.pop_front()) hand_on(waiting_.front(), time_s);
}

void CutClock::fetch() {
  const std::scoped_lock lock(mutex_);
  ends_.insert(ends_.end(), told_.begin(), told_.end());
  told_.clear();
}

// A dwell has an end, and cuts nothing; a move that goes nowhere cuts nothing and has none.
void CutClock::join() {
  while (!waiting_.empty() && !ends_.empty()) {
    const End& end = ends_.front();
    if (end.motion < waiting_.front().motion) {
      last_s_ = end.time_s;
      ends_.pop_front();
      continue;
    }
    hand_on(waiting_.front(), end.motion == waiting_.front().motion ? end.time_s : last_s_);
    waiting_.pop_front();
  }
}

void CutClock::hand_on(const MotionCut& cut, double end_s) {
  TimedCut timed{.cut = cut, .start_s = last_s_, .end_s = std::max(last_s_, end_s)};
  const double lasts_s = timed.end_s - timed.start_s;
  last_s_ = timed.end_s;
  const CuttingData& data = cut.data;
  if (lasts_s > 0) timed.mrr_mm3_s = data.told_mm3 / lasts_s;
  timed.power_kw = data.kc > 0 ? removal_kw(timed.mrr_mm3_s, data.kc) : data.feed_kw;
  if (data.rpm > 0) timed.torque_nm = torque_nm(timed.power_kw, data.rpm);
  for (TimedCutSink* const sink : sinks_) sink->take(timed);
}

}  // namespace kerf::stock
