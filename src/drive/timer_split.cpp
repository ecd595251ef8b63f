#include "drive/timer_split.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/decimal.hpp"

namespace kerf::drive {

base::Result<HalfPeriod> split_half_period(TimerSplit split, std::int64_t most, std::int64_t pulses,
                                           std::int64_t half_period_ticks) {
  assert(1 <= pulses && pulses <= most && most <= kMostPulses);
  assert(1 <= half_period_ticks && half_period_ticks <= kLongestHalfPeriod);
  const HalfPeriod exact{most * half_period_ticks, pulses};
  if (split == TimerSplit::exact) return exact;
  const std::int64_t ticks = exact.numerator / exact.denominator;
  if (ticks <= kMostTimerTicks) return HalfPeriod{ticks, 1};
  return base::unexpected(base::make_error(
      base::Code::timer_overflow, {},
      fmt::format("{} pulses in the time of {} need a half period of {} ticks ({:X}H); the timer "
                  "counts at most {} ({:X}H)",
                  pulses, most, ticks, ticks, kMostTimerTicks, kMostTimerTicks),
      "drive.split = \"exact\" has no such limit"));
}

std::int64_t speed_true_half_period(double path_mm, double speed_mm_s, double tick_s,
                                    std::int64_t most, std::int64_t least_ticks) {
  if (most == 0) return least_ticks;
  const double ticks = path_mm / (speed_mm_s * 2 * static_cast<double>(most) * tick_s);
  return std::clamp(base::round_away(ticks), least_ticks, kLongestHalfPeriod);
}

}  // namespace kerf::drive
