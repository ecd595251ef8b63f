#pragma once

#include <optional>
#include <string>

#include "motion/axis_setup.hpp"

namespace kerf::process {

/// What a plan has to know of the machine that makes it.
struct MachineFacts {
  std::string name;
  motion::AxisSetup axes;       ///< the program's
  bool has_beam = false;        ///< else a mill
  bool makes_patterns = false;  ///< an engraving arm: no speeds, no power
  double fastest_feed = 0;      ///< mm/min in X and Y
  double max_power_w = 0;
  double frequency_hz = 0;
  double kerf_mm = 0;   ///< of the beam
  double focus_mm = 0;  ///< Z of cuts whose job says none
  std::string gas;
  bool z_first = false;  ///< the focus is set before X and Y also where it falls
};

}  // namespace kerf::process
