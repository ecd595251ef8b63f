#pragma once

#include "drive/arm_drive.hpp"
#include "drive/pwm.hpp"
#include "drive/step_generator.hpp"

namespace kerf::machine {

/// The laser of a machine and the timer that makes its pulses.
struct LaserSettings {
  double max_power_w = 0;          ///< while the beam is on, >= 0; 0: there is no laser
  double pwm_frequency_hz = 2000;  ///< > 0
  double spot_mm = 0.1;            ///< diameter of the spot on the work, > 0
  drive::PwmTimer timer;

  [[nodiscard]] bool fitted() const { return max_power_w > 0; }
};

/// Constants of what makes a machine's pulses.
struct DriveSettings {
  drive::StepTiming timing;
  drive::ArmSettings arm;
  LaserSettings laser;
};

}  // namespace kerf::machine
