#include "lang/gcode/loops.hpp"

namespace kerf::gcode {

using State = vm::Region::State;

void LoopMatcher::take_do(std::uint8_t slot, vm::Address head, bool asked) {
  Slots open_around;
  for (std::size_t i = 0; i < newest_.size(); ++i) open_around[i] = newest_[i].mark == Mark::head;
  ++order_;
  newest_[slot] = {Mark::head, order_};
  if (asked) waiting_[slot][open_around.to_ulong()].push_back({order_, head});
}

void LoopMatcher::take_end(std::uint8_t slot, vm::Address end) {
  ++order_;
  for (Queue& queue : waiting_[slot]) settle_behind(queue, 0, {State::closed, end});
  settle_others(slot);
  newest_[slot] = {Mark::end, order_};
}

// What this END means for DOs of other numbers. Behind a DO of its own number it ends that loop:
// those before it have it inside, those behind it are crossed. Behind an END, or at the beginning,
// it ends a loop that stands before all that still waits, if there is one.
void LoopMatcher::settle_others(std::uint8_t slot) {
  const Newest newest = newest_[slot];
  for (std::size_t other = 0; other < waiting_.size(); ++other) {
    if (other == slot) continue;
    for (std::size_t around = 0; around < waiting_[other].size(); ++around) {
      Queue& queue = waiting_[other][around];
      if (newest.mark == Mark::head) {
        settle_behind(queue, newest.order, {State::crossing, {}});
      } else if (Slots(around)[slot]) {
        settle_behind(queue, 0, {State::crossing, {}});
      } else if (from_ == From::middle) {
        settle_behind(queue, 0, {State::unresolved, {}});
      }
    }
  }
}

void LoopMatcher::finish(State state) {
  for (auto& by_around : waiting_) {
    for (Queue& queue : by_around) settle_behind(queue, 0, {state, {}});
  }
}

void LoopMatcher::settle_behind(Queue& queue, std::uint64_t order, const LoopEnding& ending) {
  while (!queue.empty() && queue.back().order > order) {
    settle_(queue.back().head, ending);
    queue.pop_back();
  }
}

}  // namespace kerf::gcode
