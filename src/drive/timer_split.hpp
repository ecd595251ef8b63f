#pragma once

#include <cstdint>

#include "base/result.hpp"

namespace kerf::drive {

/// How the arm with fewer pulses finds its half period (docs/drives.md, "The arm's timers").
enum class TimerSplit : std::uint8_t {
  exact,    ///< a fraction of ticks; each edge is rounded once. Both arms end together.
  integer,  ///< whole ticks in a 16-bit timer, as the controller's program has it
};

/// Ticks of a 16-bit timer that counts up from its initial value to overflow.
inline constexpr std::int64_t kMostTimerTicks = 0x10000;

/// Most pulses of one move, and the longest half period in ticks: with these, no product overflows.
inline constexpr std::int64_t kMostPulses = 65535;
inline constexpr std::int64_t kLongestHalfPeriod = std::int64_t{1} << 24;

/// Time from edge to edge of one axis, in ticks: numerator / denominator, both > 0.
struct HalfPeriod {
  std::int64_t numerator = 1;
  std::int64_t denominator = 1;

  /// When the line toggles for the `number`th time, from 1: odd edges rise, even ones fall. Ticks
  /// from the start of the move, rounded once, ties upwards.
  [[nodiscard]] std::int64_t edge(std::int64_t number) const {
    return (2 * number * numerator + denominator) / (2 * denominator);
  }
};

/// Half period of an axis with `pulses` pulses that moves together with one of `most` pulses, whose
/// half period is `half_period_ticks`. 1 <= pulses <= most <= kMostPulses; the half period is in
/// 1 to kLongestHalfPeriod.
/// Error TIMER_OVERFLOW, in integer mode: the half period is longer than kMostTimerTicks.
[[nodiscard]] base::Result<HalfPeriod> split_half_period(TimerSplit split, std::int64_t most,
                                                         std::int64_t pulses,
                                                         std::int64_t half_period_ticks);

/// What is loaded into the timer for a half period of 1 to kMostTimerTicks; 10000H loads 0000H.
constexpr std::uint16_t timer_initial_value(std::int64_t half_period_ticks) {
  return static_cast<std::uint16_t>(kMostTimerTicks - half_period_ticks);
}

/// Half period, in ticks, with which a tool that goes `path_mm` in `most` pulses of the faster arm
/// moves at `speed_mm_s`, but never shorter than `least_ticks`, which the motor needs. Without a
/// path or pulses it is `least_ticks`. At most kLongestHalfPeriod.
[[nodiscard]] std::int64_t speed_true_half_period(double path_mm, double speed_mm_s, double tick_s,
                                                  std::int64_t most, std::int64_t least_ticks);

}  // namespace kerf::drive
