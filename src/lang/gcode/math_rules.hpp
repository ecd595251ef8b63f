#pragma once

#include <cstdint>

namespace kerf::gcode {

/// Parameters of the control that change how its functions calculate (docs/parameters.md).
struct MathRules {
  bool signed_angles = false;  ///< NAT (6004#0): ATAN −180…180, ASIN −90…90 instead of 0…360
  bool small_is_zero = true;  ///< MFZ (6004#1): |SIN, COS, TAN| below 1e-8 is 0
  double adp_factor = 1000;   ///< what ADP multiplies by: least increments in a unit
};

}  // namespace kerf::gcode
