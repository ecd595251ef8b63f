#pragma once

#include <optional>

#include "geometry/contour/edge.hpp"

namespace kerf::features {

// The ways in which people say an arc. Nothing: there is no such arc, or it is a whole circle,
// which is two elements.

[[nodiscard]] std::optional<contour::Edge> arc_through(contour::Vec2 first, contour::Vec2 second,
                                                       contour::Vec2 third);
[[nodiscard]] std::optional<contour::Edge> arc_about(contour::Vec2 centre, double radius,
                                                     double start_deg, double end_deg,
                                                     bool is_clockwise);
/// Between the ends of an arc, on the same side and the same way round, long or short.
[[nodiscard]] std::optional<contour::Edge> with_radius(const contour::Edge& arc, double radius);

}  // namespace kerf::features
