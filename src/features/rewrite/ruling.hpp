#pragma once

#include <vector>

#include "geometry/contour/region.hpp"

namespace kerf::features {

/// Parallel lines: how they run, and to which side they follow each other. Unit vectors, square to
/// each other.
struct Ruling {
  contour::Vec2 along{1, 0};
  contour::Vec2 across{0, 1};

  [[nodiscard]] contour::Vec2 point(double on_line, double line) const {
    return on_line * along + line * across;
  }
};

/// From one place to another, ascending.
struct Interval {
  double from = 0;
  double to = 0;
};

/// From the first to the last line that meets a region.
[[nodiscard]] Interval lines_across(const contour::Region& region, const Ruling& ruling);

/// The parts of a line that lie in a region or on its border, in their order.
[[nodiscard]] std::vector<Interval> parts_of_line(const contour::Region& region,
                                                  const Ruling& ruling, double line);

}  // namespace kerf::features
