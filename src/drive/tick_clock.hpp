#pragma once

#include <cstdint>

namespace kerf::drive {

/// The clock of the arm's timers: one tick every 12 periods of the crystal. Conversions to ns are
/// exact but for one rounding, ties upwards.
class TickClock {
 public:
  /// The arm's crystal: 11.0592 MHz, ticks of 1.085 us.
  TickClock() : TickClock(11'059'200) {}
  /// `crystal_hz` in 1 to 500,000,000.
  explicit TickClock(std::int64_t crystal_hz);

  [[nodiscard]] double tick_s() const { return 12.0 / static_cast<double>(crystal_hz_); }

  /// Time of a tick >= 0.
  [[nodiscard]] std::int64_t nanoseconds(std::int64_t ticks) const {
    return ticks / per_ * ns_ + (ticks % per_ * ns_ * 2 + per_) / (2 * per_);
  }
  /// The nearest tick.
  [[nodiscard]] std::int64_t ticks(double seconds) const;

 private:
  std::int64_t crystal_hz_;
  std::int64_t ns_;  // `per_` ticks last `ns_` nanoseconds; lowest terms
  std::int64_t per_;
};

}  // namespace kerf::drive
