#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "features/edit/edit.hpp"
#include "features/edit/fault.hpp"
#include "features/edit/outline.hpp"
#include "geometry/contour/contour.hpp"

namespace kerf::features {

/// The contours of a layer, outer and islands, closed, in normal form. The outer one of a lathe,
/// and a centre line, may be open.
struct LayerContours {
  contour::Contour outer{};
  std::vector<contour::Contour> islands{};
};

/// Edits the contours of one layer, element by element: between two edits they may be open, or
/// cross. Elements keep their numbers until the end; those that come in have the next free ones.
class ContourEdit {
 public:
  /// `turns`: of a lathe, as contours are told: (z, x), x a diameter. Bulges are those of the arcs
  /// that the tool moves along, so all of it is edited by radii.
  explicit ContourEdit(const LayerContours& contours, bool turns = false);

  /// Applies an operation that changes contours: ReplaceContour to DeleteIsland, RotateFeature and
  /// ScaleFeature (about the centre of the outer contour's bounding box where no point is said),
  /// MoveFeature by dx and dy, of a lathe by dz and dx; all others change nothing. What replaces a
  /// contour is numbered by its normal form; it is open where the old one is. `island`: which one;
  /// none: the outer contour, and the islands where all of the feature is placed. What is refused
  /// changes nothing. Faults: EDIT_LAYER_UNKNOWN (no such island), EDIT_ELEMENT_UNKNOWN,
  /// EDIT_DOES_NOT_FIT, EDIT_NO_MEETING.
  [[nodiscard]] Editing<void> apply(const EditOperation& operation,
                                    std::optional<std::size_t> island);

  /// A contour as it is between two edits, as contours are told.
  struct Shown {
    std::optional<std::size_t> island{};  ///< none: the outer contour
    bool is_closed = true;                ///< shall be
    std::vector<Outline::Step> elements{};
  };
  /// All of them, also those that are open or cross.
  [[nodiscard]] std::vector<Shown> shown() const;

  /// What they have become, in normal form. Faults in this order: EDIT_NO_AREA, EDIT_OPEN,
  /// EDIT_CROSSES_ITSELF (also: an island not inside, or not apart from another).
  [[nodiscard]] Editing<LayerContours> finished() const;

 private:
  [[nodiscard]] Editing<Outline*> outline(std::optional<std::size_t> island);
  void add_island(const contour::Contour& contour);
  void replace(const ReplaceContour& wish, std::optional<std::size_t> island);
  template <typename Map>
  void move_all(std::optional<std::size_t> island, const Map& moved);
  [[nodiscard]] contour::Vec2 centre() const;
  [[nodiscard]] contour::Vec2 told(contour::Vec2 point) const;

  [[nodiscard]] Editing<void> change(const ReplaceContour& wish, std::optional<std::size_t> island);
  [[nodiscard]] Editing<void> change(const AddIsland& wish, std::optional<std::size_t> island);
  [[nodiscard]] Editing<void> change(const DeleteIsland& wish, std::optional<std::size_t> island);
  [[nodiscard]] Editing<void> change(const MoveFeature& wish, std::optional<std::size_t> island);
  [[nodiscard]] Editing<void> change(const RotateFeature& wish, std::optional<std::size_t> island);
  [[nodiscard]] Editing<void> change(const ScaleFeature& wish, std::optional<std::size_t> island);
  /// An operation on the elements of one contour.
  template <typename Operation>
  [[nodiscard]] Editing<void> change(const Operation& wish, std::optional<std::size_t> island);

  bool turns_ = false;
  Outline outer_;
  std::vector<std::optional<Outline>>
      islands_;  ///< nothing: deleted; the others keep their numbers
};

}  // namespace kerf::features
