#include "drive/slow_move.hpp"

#include <algorithm>
#include <cstdlib>

namespace kerf::drive {
namespace {

// What part `part` of `parts` gets of a count. Rounds towards zero, so both signs split alike.
std::int64_t share(std::int64_t count, std::int64_t part, std::int64_t parts) {
  return count * (part + 1) / parts - count * part / parts;
}

}  // namespace

SlowMoveSplitter::SlowMoveSplitter(const SlowMove& move) : move_(move) {
  const std::int64_t most = std::max(std::abs(move.theta1), std::abs(move.theta2));
  parts_ = std::max<std::int64_t>(1, (most + kMostTripletPulses - 1) / kMostTripletPulses);
}

std::optional<SlowMove> SlowMoveSplitter::next() {
  const std::int64_t turn = std::clamp(move_.theta3, -kMostTripletPulses, kMostTripletPulses);
  move_.theta3 -= turn;
  if (move_.theta3 != 0) return SlowMove{turn, 0, 0};
  if (part_ == parts_) return std::nullopt;
  const SlowMove triplet{turn, share(move_.theta1, part_, parts_),
                         share(move_.theta2, part_, parts_)};
  ++part_;
  if (triplet == SlowMove{}) return std::nullopt;  // only a move of nothing has such a part
  return triplet;
}

}  // namespace kerf::drive
