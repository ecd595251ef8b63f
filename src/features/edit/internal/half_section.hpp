#pragma once

#include "features/edit/edit.hpp"

namespace kerf::features {

/// The same operation on contours that are told in another measure of their second coordinate:
/// `times` 0.5 makes radii of the diameters of a lathe. Bulges stay.
[[nodiscard]] EditOperation in_measure(EditOperation operation, double times);
[[nodiscard]] contour::Contour in_measure(contour::Contour contour, double times);

}  // namespace kerf::features
