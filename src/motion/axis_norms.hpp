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

  [[nodiscard]] double mm(const base::AxisVector& v) const { return std::sqrt(squares(v, true)); }
  [[nodiscard]] double degrees(const base::AxisVector& v) const {
    return std::sqrt(squares(v, false));
  }
  [[nodiscard]] double larger(const base::AxisVector& v) const {
    return std::sqrt(std::max(squares(v, true), squares(v, false)));
  }

 private:
  [[nodiscard]] double squares(const base::AxisVector& v, bool of_linear) const {
    double sum = 0;
    for (std::size_t m = 0; m < axes; ++m) {
      if (linear[m] == of_linear) sum += v.values[m] * v.values[m];
    }
    return sum;
  }
};

}  // namespace kerf::motion
