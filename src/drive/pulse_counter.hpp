#pragma once

#include <array>

#include "drive/pulse_sink.hpp"

namespace kerf::drive {

/// Where the motors stand after the pulses that were taken: one signed count per axis, in steps.
class PulseCounter : public PulseSink {
 public:
  void take(const Pulse& pulse) override {
    counts_[base::index(pulse.axis)] += sign(pulse.direction);
  }

  [[nodiscard]] std::int64_t count(base::Axis axis) const { return counts_[base::index(axis)]; }

 private:
  std::array<std::int64_t, base::kMaxAxes> counts_{};
};

}  // namespace kerf::drive
