#pragma once

namespace kerf::machine {

/// From the least to the most.
struct Range {
  double least;
  double most;
  [[nodiscard]] constexpr bool has(double value) const { return least <= value && value <= most; }
};

}  // namespace kerf::machine
