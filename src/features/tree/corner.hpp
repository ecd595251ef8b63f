#pragma once

#include <optional>

#include "geometry/contour/edge.hpp"

namespace kerf::features {

/// Where the line before an arc and the one behind it meet, if the arc rounds their corner: it goes
/// over smoothly into both. Nothing: it is no rounded corner.
[[nodiscard]] std::optional<contour::Vec2> corner_of(const contour::Edge& before,
                                                     const contour::Edge& arc,
                                                     const contour::Edge& behind);

}  // namespace kerf::features
