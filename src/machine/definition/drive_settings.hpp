#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "drive/arm_drive.hpp"
#include "drive/pwm.hpp"
#include "drive/step_generator.hpp"

namespace kerf::machine {

/// The laser of a machine and the timer that makes its pulses.
struct LaserSettings {
  /// How G-code for a laser controller has the beam on: M3, constant power, or M4, power that
  /// follows the speed.
  enum class Beam : std::uint8_t { constant, dynamic };

  double max_power_w = 0;          ///< while the beam is on, >= 0; 0: there is no laser
  double pwm_frequency_hz = 2000;  ///< > 0
  double spot_mm = 0.1;            ///< diameter of the spot on the work, > 0
  double kerf_mm = 0;              ///< width of a cut; 0: that of the spot
  double focus_mm = 0;   ///< Z of cuts whose job says none: where the focus is as it should be
  std::string gas;       ///< that is blown into such cuts; empty: none
  double burn_j_mm = 0;  ///< places with more energy burn, J/mm; 0: more than twice the median
  drive::PwmTimer timer;
  std::optional<int> timer_number;  ///< 0 to 3: which one of the chip it is
  double s_of_full_power = 1000;    ///< S of full power in G-code, read and written, > 0
  Beam post_beam = Beam::constant;

  [[nodiscard]] bool fitted() const { return max_power_w > 0; }
  [[nodiscard]] double width_of_cut() const { return kerf_mm > 0 ? kerf_mm : spot_mm; }
};

/// Constants of what makes a machine's pulses.
struct DriveSettings {
  drive::StepTiming timing;
  drive::ArmSettings arm;
  LaserSettings laser;
};

}  // namespace kerf::machine
