#pragma once

#include "geometry/contour/contour.hpp"

namespace kerf::features {

/// Whether a disc of this radius that goes once along a loop leaves something standing inside it.
[[nodiscard]] bool is_left_inside(const contour::Contour& loop, double radius);

}  // namespace kerf::features
