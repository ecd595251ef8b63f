#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "features/edit/edit.hpp"
#include "features/edit/fault.hpp"
#include "geometry/contour/contour.hpp"

namespace kerf::features {

/// The contours of a layer, outer and islands, closed, in normal form.
struct LayerContours {
  contour::Contour outer{};
  std::vector<contour::Contour> islands{};
};

/// Edits the contours of one layer, element by element: between two edits they may be open, or
/// cross. Elements keep their numbers until the end; those that come in have the next free ones.
class ContourEdit {
 public:
  explicit ContourEdit(const LayerContours& contours);

  /// Applies an operation that changes contours: ReplaceContour to DeleteIsland, RotateFeature and
  /// ScaleFeature (about the centre of the outer contour's bounding box where no point is said),
  /// MoveFeature by dx and dy. `island`: which one; none: the outer contour. Faults:
  /// EDIT_ELEMENT_UNKNOWN, EDIT_DOES_NOT_FIT, EDIT_NO_MEETING.
  [[nodiscard]] Editing<void> apply(const EditOperation& operation,
                                    std::optional<std::size_t> island);

  /// What they have become, in normal form. Faults in this order: EDIT_NO_AREA, EDIT_OPEN,
  /// EDIT_CROSSES_ITSELF (also: an island not inside, or not apart from another).
  [[nodiscard]] Editing<LayerContours> finished() const;

 private:
  struct Outline {
    std::vector<std::optional<contour::Edge>> elements;  // nothing: deleted
    std::vector<std::size_t> order;                      // of the elements along the contour
  };
  [[nodiscard]] Editing<Outline*> outline(std::optional<std::size_t> island);

  Outline outer_;
  std::vector<std::optional<Outline>> islands_;
};

}  // namespace kerf::features
