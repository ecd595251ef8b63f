#pragma once

#include <array>

#include "drive/arm_axis.hpp"

namespace kerf::drive {

/// A travel move of one motor. A count of 0 moves nothing.
struct FastMove {
  ArmAxis axis = ArmAxis::z;
  std::int64_t count = 0;

  friend bool operator==(const FastMove&, const FastMove&) = default;
};

/// The fast moves that bring every counter to 0, from wherever they stand: the tool is lifted to
/// `safe_z` if it is lower, then theta3, theta1 and theta2 go home, then the lift. When only the
/// lift is away from 0 it goes there at once.
[[nodiscard]] std::array<FastMove, 5> return_to_start(const ArmCounts& counters,
                                                      std::int64_t safe_z);

}  // namespace kerf::drive
