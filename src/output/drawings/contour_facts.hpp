#pragma once

#include <cstddef>

#include "geometry/contour/contour.hpp"

namespace kerf::output {

/// How many lines and arcs a contour has; one that is a whole circle has one arc.
struct EdgeCounts {
  std::size_t lines = 0;
  std::size_t arcs = 0;
};
[[nodiscard]] EdgeCounts edge_counts(const contour::Contour& path);

}  // namespace kerf::output
