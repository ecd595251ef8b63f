#pragma once

#include <cstdint>

namespace kerf::drive {

/// Speeds of a fast move, one axis alone. Pulses per second; 0 < start <= rate, acceleration > 0.
struct FastRamp {
  double rate_hz = 400;
  double start_hz = 112.5;          ///< a motor at rest follows this at once
  double acceleration_hz_s = 1000;  ///< the rate rises and falls linearly over time
};

/// A fast move of `pulses` >= 1: starts and ends at start_hz; a move too short for rate_hz turns
/// round at a lower one.
class FastProfile {
 public:
  FastProfile(const FastRamp& ramp, std::int64_t pulses);

  /// When the line is for the `number`th time to toggle, from 1 to 2 * pulses: s from the start of
  /// the move. Pulse k rises after k - 1/2 pulses of way, so the count is never more than half a
  /// pulse from the profile; the last edge ends the move.
  [[nodiscard]] double edge_s(std::int64_t number) const;

  /// The move of the fewest pulses whose edges are those of this one up to `way` pulses from the
  /// start: who is on the way and wants to rest makes that one. At most the pulses of this one.
  [[nodiscard]] std::int64_t fewest_pulses(double way) const;

 private:
  [[nodiscard]] double ramp_time_s(double way) const;

  FastRamp ramp_;
  double pulses_;
  double peak_hz_;
  double ramp_pulses_;  // way of each ramp
  double duration_s_;
};

}  // namespace kerf::drive
