#pragma once

#include "drive/pulse.hpp"

namespace kerf::drive {

/// Takes pulses one by one, in the order of their times.
class PulseSink {
 public:
  PulseSink() = default;
  virtual ~PulseSink() = default;
  PulseSink(const PulseSink&) = delete;
  PulseSink& operator=(const PulseSink&) = delete;

  virtual void take(const Pulse& pulse) = 0;
};

}  // namespace kerf::drive
