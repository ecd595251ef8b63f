#pragma once

#include <optional>
#include <span>
#include <vector>

namespace kerf::drawing {

/// The slopes at which the cubics between values have two steady derivatives. `at` ascends
/// strictly and has at least two places. Where no slope is given at an end, the curvature is 0
/// there.
[[nodiscard]] std::vector<double> spline_slopes(std::span<const double> at,
                                                std::span<const double> values,
                                                std::optional<double> first_slope = {},
                                                std::optional<double> last_slope = {});

/// Likewise of values that begin again: `at` has one place more than there are values, at least
/// three, which is where the first one comes again.
[[nodiscard]] std::vector<double> periodic_slopes(std::span<const double> at,
                                                  std::span<const double> values);

}  // namespace kerf::drawing
