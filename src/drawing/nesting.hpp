#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/contour/contour.hpp"

namespace kerf::drawing {

/// How a closed contour lies among others.
struct Nest {
  std::size_t depth = 0;              ///< how many others it lies in
  std::optional<std::size_t> parent;  ///< the innermost of these
};

/// Of each of `contours`; an open one, and one that lies on the border of another, lies in nothing.
[[nodiscard]] std::vector<Nest> nests_of(std::span<const contour::Contour> contours);

}  // namespace kerf::drawing
