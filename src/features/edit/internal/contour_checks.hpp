#pragma once

#include <vector>

#include "features/edit/fault.hpp"
#include "features/edit/outline.hpp"

namespace kerf::features {

/// A contour as its elements are now.
struct MadeContour {
  const Outline* outline = nullptr;
  std::vector<Outline::Step> steps{};
};

/// Names of coordinates in sentences: "X30 Y24"; of a lathe Z, and X as a diameter.
struct AxisNames {
  bool turns = false;

  [[nodiscard]] std::string place(contour::Vec2 point) const;
};

/// The contour that the elements make, in their order; where one does not end in the next one's
/// beginning a line leads there, so that each edge is an element's or such a line.
[[nodiscard]] contour::Contour bridged(const MadeContour& made);

// The checks of features-contract §6, of the outer contour first and then of the islands.

[[nodiscard]] Editing<void> check_area(const std::vector<MadeContour>& made);
[[nodiscard]] Editing<void> check_closed(const std::vector<MadeContour>& made);
/// Of closed ones.
[[nodiscard]] Editing<void> check_apart(const std::vector<MadeContour>& made,
                                        const AxisNames& names);

}  // namespace kerf::features
