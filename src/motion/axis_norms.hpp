#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/axes.hpp"
#include "motion/axis_setup.hpp"

namespace kerf::motion {

/// Which axes count mm; the others count degrees.
using LinearAxes = std::array<bool, base::kMaxAxes>;

[[nodiscard]] inline LinearAxes linear_axes(const AxisSetup& axes) {
  LinearAxes linear{};
  for (std::size_t m = 0; m < axes.count(); ++m) linear[m] = !axes.axes[m].rotary;
  return linear;
}

/// How long vectors of the first `axes` axes are: the Euclidean norm of those that count mm, of
/// those that count degrees, or the larger one of both. Value type.
struct AxisNorms {
  LinearAxes linear{};
  std::size_t axes = 0;

  [[nodiscard]] double mm(const base::AxisVector& v) const { return std::sqrt(squares(v)[0]); }
  [[nodiscard]] double degrees(const base::AxisVector& v) const { return std::sqrt(squares(v)[1]); }
  [[nodiscard]] double larger(const base::AxisVector& v) const {
    const auto both = squares(v);
    return std::sqrt(std::max(both[0], both[1]));
  }

 private:
  [[nodiscard]] std::array<double, 2> squares(const base::AxisVector& v) const {
    std::array<double, 2> sums{};
    for (std::size_t m = 0; m < axes; ++m) sums[linear[m] ? 0 : 1] += v.values[m] * v.values[m];
    return sums;
  }
};

}  // namespace kerf::motion
