#pragma once

#include <optional>
#include <vector>

#include "features/edit/contour_edit.hpp"
#include "features/edit/edit.hpp"
#include "features/edit/fault.hpp"
#include "features/path/recording.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// Contours as edits have left them, whether or not they can be cut.
struct EditSketch {
  struct Outline {
    std::size_t feature = 0;  ///< places, from 0
    std::size_t layer = 0;
    ContourEdit::Shown contour{};
  };
  std::vector<Outline> contours{};  ///< of what the edits name
  /// What is wrong with an edit or with a contour itself; none: whether a tool can cut it is
  /// another question.
  std::optional<EditFault> fault{};
};

/// Applies edits in their order as far as they can be applied. No path is made.
[[nodiscard]] EditSketch sketch_edits(const Recording& recording, const Tree& tree,
                                      const std::vector<Edit>& edits);

}  // namespace kerf::features
