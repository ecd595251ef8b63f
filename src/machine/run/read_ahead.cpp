#include "machine/run/read_ahead.hpp"

namespace kerf::machine {

void ReadAhead::take(const motion::Motion& /*motion*/) {
  ++motions_;
  const Place now = newest();
  if (now == (entries_.empty() ? last_ : entries_.back().place)) return;
  if (entries_.size() < kMost) {
    entries_.push_back({motions_, now});
  } else {
    entries_.back().place = now;
  }
}

ReadAhead::Place ReadAhead::at(std::uint64_t motion) {
  while (!entries_.empty() && entries_.front().first <= motion) {
    last_ = entries_.front().place;
    entries_.pop_front();
  }
  return last_;
}

}  // namespace kerf::machine
