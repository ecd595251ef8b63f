#pragma once

#include <limits>
#include <string>

namespace kerf::kinematics {

/// One driven axis: its name in the machine file, and its range, low <= high, in mm or, when
/// rotary, degrees. Infinite ends are no limit.
struct Joint {
  std::string name;
  bool rotary = false;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

}  // namespace kerf::kinematics
