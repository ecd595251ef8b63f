#pragma once

#include <cstdint>

namespace kerf::control {

/// Which work coordinate system is active.
struct WorkSystem {
  std::uint32_t index = 0;     ///< 0 to 5: G54 to G59
  std::uint32_t extended = 0;  ///< 1 to 300: G54.1 P; 0: one of the six
};

}  // namespace kerf::control
