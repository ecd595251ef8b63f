#pragma once

#include <string>
#include <vector>

#include "drawing/cleaning.hpp"
#include "drawing/drawing.hpp"
#include "process/passes.hpp"

namespace kerf::process {

/// A drawing where it lies on the machine.
struct Sheet {
  std::vector<Outline> outlines;  ///< of Cleaned::chains, in their order
  std::vector<drawing::Point> points;
  drawing::Affine placed;  ///< from the drawing to the machine
};

/// The map that [place] asks for: scale or fit, mirror, rotate, and the anchor comes to `at`.
[[nodiscard]] drawing::Affine placement(const PlaceWords& place, const contour::Box& extents);

/// Contours as placed; arcs under an unequal scale become arcs within the tolerance again.
[[nodiscard]] Sheet placed(const drawing::Drawing& drawing, const drawing::Cleaned& cleaned,
                           const drawing::Affine& map, double tolerance_mm);

[[nodiscard]] contour::Box extents_of(const drawing::Cleaned& cleaned);

}  // namespace kerf::process
