#pragma once

#include <algorithm>
#include <cstdlib>

#include "drive/pattern/record.hpp"

namespace kerf::drive {

// Moves of any length as the records that make them (docs/pattern.md, "Moves").

constexpr PulseField pulse_field(std::int64_t count) {
  return {static_cast<std::uint16_t>(count < 0 ? -count : count), count < 0};
}

/// Calls `take(FastRecord)` for each record of a fast move: of 65535 pulses as long as there are as
/// many, then of the rest. A move of nothing has no record.
template <typename Take>
void each_record(const FastMove& move, Take&& take) {
  for (std::int64_t left = move.count; left != 0;) {
    const std::int64_t part = std::clamp(left, -kMostFastPulses, kMostFastPulses);
    take(FastRecord{move.axis, pulse_field(part)});
    left -= part;
  }
}

/// Calls `take(Triplet)` for each triplet that SlowMoveSplitter makes of a cut.
template <typename Take>
void each_record(const SlowMove& move, Take&& take) {
  SlowMoveSplitter splitter(move);
  while (const auto part = splitter.next()) {
    take(Triplet{{pulse_field(part->theta3), pulse_field(part->theta1), pulse_field(part->theta2)},
                 Triplet::kAxes});
  }
}

}  // namespace kerf::drive
