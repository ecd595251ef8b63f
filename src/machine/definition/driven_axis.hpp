#pragma once

#include <array>
#include <limits>
#include <string>

namespace kerf::machine {

/// One driven axis: what a motor moves, on a linkage a joint. mm, or degrees when rotary, and
/// seconds unless the name says otherwise (docs/machine-file.md).
struct DrivenAxis {
  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();

  std::string name;  ///< a letter, or T1, T2, T3
  bool rotary = false;
  bool diameter = false;          ///< programs say twice its way (AxisConfig::diameter)
  double velocity_per_min = 0;    ///< > 0
  double acceleration = 1000;     ///< > 0
  double jerk = kNoLimit;         ///< > 0
  double travel_low = -kNoLimit;  ///< machine coordinates, < travel_high
  double travel_high = kNoLimit;
  std::array<double, 4> reference{};  ///< 1st to 4th reference point, machine coordinates
  double steps_per_unit = 100;        ///< not 0; negative turns the motor round
  double most_rate_hz = 0;            ///< fastest steps; 0: only the amplifier limits them
};

}  // namespace kerf::machine
