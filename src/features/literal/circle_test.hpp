#pragma once

#include <optional>

#include "geometry/contour/contour.hpp"

namespace kerf::features {

struct Circle {
  geometry::Vec2 centre{};
  double radius = 0;
};

/// The circle that a closed contour is: arcs of one circle that turn once, or chords of one, at
/// least 12, none over more than 45 degrees, and as near to it as such chords are.
[[nodiscard]] std::optional<Circle> circle_of(const contour::Contour& contour);

}  // namespace kerf::features
