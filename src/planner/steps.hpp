#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace kerf::planner {

/// How many steps a way of `way` > 0 takes, the last of which may be shorter: ⌈way / step⌉, where a
/// quotient that exceeds a whole number by no more than a billionth is that number. At least 1.
[[nodiscard]] inline std::uint64_t count_steps(double way, double step) {
  constexpr double kWhole = 1e-9;
  constexpr double kMost = 9e15;  // still a whole number
  return static_cast<std::uint64_t>(std::clamp(std::ceil(way / step - kWhole), 1.0, kMost));
}

}  // namespace kerf::planner
