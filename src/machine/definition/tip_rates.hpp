#pragma once

namespace kerf::machine {

/// Rates of the tip's X and Y on a linkage none of whose joints moves along them. The joints keep
/// their own limits: these are what the control takes for the rapid rate.
struct TipRates {
  double velocity_per_min = 6000;  ///< mm/min, > 0
  double acceleration = 1000;      ///< mm/s², > 0
};

}  // namespace kerf::machine
