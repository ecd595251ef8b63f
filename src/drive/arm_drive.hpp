#pragma once

#include "base/result.hpp"
#include "drive/arm_axis.hpp"
#include "drive/fast_profile.hpp"
#include "drive/pulse_sink.hpp"
#include "drive/return_to_start.hpp"
#include "drive/slow_move.hpp"
#include "drive/tick_clock.hpp"
#include "drive/timer_split.hpp"

namespace kerf::drive {

struct ArmSettings {
  TickClock clock;
  TimerSplit split = TimerSplit::exact;
  std::int64_t half_period_ticks = 0x1000;  ///< of slow moves, 1 to kLongestHalfPeriod
  FastRamp fast;
};

/// Makes the pulses of the two-link arm (docs/drives.md, "The arm's timers"). Moves follow one
/// another without a pause; each starts with every line low. Edges lie on ticks of the clock, times
/// of pulses are those ticks in ns. Counters follow every pulse. A value: a copy goes on by itself.
class ArmDrive {
 public:
  /// The sink must outlive the drive.
  ArmDrive(const ArmSettings& settings, PulseSink& sink) : settings_(settings), sink_(&sink) {}

  /// A triplet: theta3 alone, then theta1 and theta2 together. At most kMostPulses an axis. The
  /// half period of the arms is the setting's, or `half_period_ticks`, from
  /// speed_true_half_period().
  /// Error TIMER_OVERFLOW as split_half_period(); then nothing has moved, not even theta3.
  [[nodiscard]] base::Result<void> slow(const SlowMove& triplet);
  [[nodiscard]] base::Result<void> slow(const SlowMove& triplet, std::int64_t half_period_ticks);

  /// All four motors together, in the time of the one with the most pulses. Limits and error as
  /// slow().
  [[nodiscard]] base::Result<void> linked(const ArmCounts& counts);

  /// One motor alone with a linear ramp. More than kMostPulses are made as several moves, as the
  /// records of a pattern hold no more; each has its ramps.
  void fast(const FastMove& move);

  [[nodiscard]] const ArmCounts& counters() const { return counters_; }

  /// Ticks since the start, at the end of the last move.
  [[nodiscard]] std::int64_t now_ticks() const { return now_; }

  /// The motors stand elsewhere, after moves that were broken off.
  void set_counters(const ArmCounts& counters) { counters_ = counters; }

 private:
  // What one motor has still to do of a move.
  struct Train {
    ArmAxis axis;
    Direction direction;
    std::int64_t pulses;
    HalfPeriod half;
    std::int64_t done = 0;

    [[nodiscard]] std::int64_t rise() const { return half.edge(2 * done + 1); }
    [[nodiscard]] std::int64_t fall() const { return half.edge(2 * done + 2); }
  };
  class Trains;

  [[nodiscard]] base::Result<Trains> plan(const ArmCounts& counts, std::int64_t half_period) const;
  void run(Trains& trains);
  void fast_record(ArmAxis axis, Direction direction, std::int64_t pulses);
  void pulse(ArmAxis axis, Direction direction, std::int64_t rise, std::int64_t fall);

  ArmSettings settings_;
  PulseSink* sink_;
  ArmCounts counters_;
  std::int64_t now_ = 0;
};

}  // namespace kerf::drive
