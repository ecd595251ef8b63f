#pragma once

#include <cmath>
#include <string>

#include "base/decimal.hpp"

namespace kerf::kinematics {

/// A value of a sentence: to 1e-6 mm or degrees.
inline std::string shown(double value) { return base::number_text(std::round(value * 1e6) / 1e6); }

}  // namespace kerf::kinematics
