#pragma once

#include <functional>
#include <vector>

#include "features/tree/feature.hpp"

namespace kerf::features {

/// The contour that a tool has left: where what was removed borders on what is left, which is where
/// its edges are `own`. The longest connected part, from the end nearest to `begin`. Open, with the
/// owners of its edges.
[[nodiscard]] contour::Contour left_contour(const contour::Region& removed,
                                            const std::function<bool(std::uint32_t)>& own,
                                            contour::Vec2 begin);

/// The contour with sharp corners where a nose of this radius has rounded them: where such an arc
/// goes over smoothly into lines on both sides.
[[nodiscard]] contour::Contour without_nose(const contour::Contour& contour, double radius);

/// Edges of a turned contour by what a drawing calls them.
[[nodiscard]] std::vector<TurnedElement> elements_of(const contour::Contour& contour);

}  // namespace kerf::features
