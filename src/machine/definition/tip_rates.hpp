#pragma once

#include <cstdint>

namespace kerf::machine {

/// How a rapid brings the tip to its end.
enum class RapidWay : std::uint8_t {
  straight,  ///< as programs of G-code want it
  joint      ///< the driven axes in proportion, from point to point (motion::TurningRapid)
};

/// Rapids of the tip. The rates are those of X and Y on a linkage none of whose joints moves along
/// them. The joints keep their own limits: these are what the control takes for the rapid rate.
struct TipRates {
  double velocity_per_min = 6000;  ///< mm/min, > 0
  double acceleration = 1000;      ///< mm/s², > 0
  RapidWay rapid = RapidWay::straight;
  bool z_first = false;  ///< Z of a rapid is brought to its place before the other axes move
};

}  // namespace kerf::machine
