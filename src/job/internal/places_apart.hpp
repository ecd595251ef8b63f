#pragma once

#include <fmt/format.h>

#include <string>

#include "stock/sweep/way.hpp"

namespace kerf::job {

/// They have no place in common.
[[nodiscard]] inline bool are_apart(const stock::Bounds& a, const stock::Bounds& b) {
  return a.low.x > b.high.x || b.low.x > a.high.x || a.low.y > b.high.y || b.low.y > a.high.y ||
         a.low.z > b.high.z || b.low.z > a.high.z;
}

/// For people.
[[nodiscard]] inline std::string ranges(const stock::Bounds& box) {
  return fmt::format("X {:.4g} to {:.4g}, Y {:.4g} to {:.4g}, Z {:.4g} to {:.4g}", box.low.x,
                     box.high.x, box.low.y, box.high.y, box.low.z, box.high.z);
}

}  // namespace kerf::job
