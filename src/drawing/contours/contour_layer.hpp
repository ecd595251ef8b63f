#pragma once

#include <string>
#include <vector>

#include "drawing/drawing.hpp"

namespace kerf::drawing {

/// What a layer has, mm.
struct ContourLayer {
  std::string name;  ///< UTF-8
  Colour colour{};
  std::vector<contour::Contour> contours;  ///< one of a single vertex is a point
};

}  // namespace kerf::drawing
