#pragma once

#include <cstdint>

#include "base/result.hpp"

namespace kerf::drive {

// The laser's pulses and the registers of the timer that makes them (docs/drives.md, "The laser").

/// A train of laser pulses. Frequency in 1/s, > 0; duty is the part of a period with the beam on,
/// in [0, 1].
struct PulseTrain {
  double frequency_hz = 0;
  double duty = 0;

  friend bool operator==(const PulseTrain&, const PulseTrain&) = default;
};

/// The train of pulses that are on for `on_s` and off for `off_s`, both >= 0, not both 0.
[[nodiscard]] PulseTrain pulse_train(double on_s, double off_s);

/// Distance between pulses on the work at a feed. Continuous cuts need it within the spot's
/// diameter.
[[nodiscard]] double pulse_pitch_mm(const PulseTrain& train, double feed_mm_s);

/// Energy per length of cut, J/mm, of a laser of `power_w` while on.
[[nodiscard]] double line_energy_j_mm(const PulseTrain& train, double power_w, double feed_mm_s);

/// A 16-bit down counter with compare match.
struct PwmTimer {
  enum class Output : std::uint8_t {
    active_after_match,   ///< mode A, inverter off: TCMPB = ticks on
    active_before_match,  ///< mode B, inverter on: TCMPB = TCNTB - ticks on
  };
  enum class Counting : std::uint8_t {
    plain,        ///< a period lasts TCNTB ticks
    hidden_tick,  ///< it lasts one more: both registers are written one lower
  };

  double clock_hz = 50e6;      ///< PCLK, > 0
  std::int64_t prescaler = 0;  ///< 0 to 255
  std::int64_t divider = 2;    ///< 2, 4, 8 or 16
  Output output = Output::active_after_match;
  Counting counting = Counting::plain;

  [[nodiscard]] double tick_hz() const {
    return clock_hz / (static_cast<double>(prescaler + 1) * static_cast<double>(divider));
  }
};

/// What the timer does for a train. Value type.
struct PwmRegisters {
  enum class Beam : std::uint8_t { off, pulsing, on };

  Beam beam = Beam::off;  ///< off and on need no pulses: the output is held
  std::int64_t tcntb = 0;
  std::int64_t tcmpb = 0;
  double frequency_hz = 0;  ///< that the timer really makes
  double duty = 0;          ///< likewise, in [0, 1]

  friend bool operator==(const PwmRegisters&, const PwmRegisters&) = default;
};

/// The registers nearest to a train; ticks are rounded, ties away from zero. A duty that rounds to
/// no tick is off, one that rounds to every tick is on.
/// Error PWM_RANGE: TCNTB as written would lie outside 1 to 65535, or a prescaler, divider,
/// frequency or duty outside of its range.
[[nodiscard]] base::Result<PwmRegisters> pwm_registers(const PwmTimer& timer,
                                                       const PulseTrain& train);

}  // namespace kerf::drive
