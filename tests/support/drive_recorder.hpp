#pragma once

#include <vector>

#include "drive/pulse_sink.hpp"

namespace kerf::test {

/// Keeps every pulse.
struct PulseRecorder : drive::PulseSink {
  void take(const drive::Pulse& pulse) override { pulses.push_back(pulse); }
  std::vector<drive::Pulse> pulses;
};

}  // namespace kerf::test
