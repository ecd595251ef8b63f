#include "drive/return_to_start.hpp"

#include <algorithm>

namespace kerf::drive {

std::array<FastMove, 5> return_to_start(const ArmCounts& counters, std::int64_t safe_z) {
  using enum ArmAxis;
  const bool arms_move = counters[theta1] != 0 || counters[theta2] != 0 || counters[theta3] != 0;
  const std::int64_t lift =
      arms_move ? std::max<std::int64_t>(0, safe_z - counters[z]) : std::int64_t{0};
  return {FastMove{z, lift}, FastMove{theta3, -counters[theta3]},
          FastMove{theta1, -counters[theta1]}, FastMove{theta2, -counters[theta2]},
          FastMove{z, -(counters[z] + lift)}};
}

}  // namespace kerf::drive
