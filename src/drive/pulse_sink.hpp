#pragma once

#include "base/interface.hpp"
#include "drive/pulse.hpp"

namespace kerf::drive {

/// Takes pulses one by one, in the order of their times.
class PulseSink : public base::Interface {
 public:
  virtual void take(const Pulse& pulse) = 0;
};

}  // namespace kerf::drive
