#pragma once

#include "features/plan/internal/edit_scene.hpp"

namespace kerf::features {

/// Under G41 and G42 the control goes beside the contour by itself: its corners alone move.
[[nodiscard]] Done follow_vertices(EditScene& scene, std::size_t feature, std::size_t layer,
                                   const LayerContours& contours);
/// The contour of what is turned, as edits begin with it.
[[nodiscard]] ContourEdit turned_contour(const EditScene& scene, std::size_t feature);
/// What is turned gets this contour: ends of passes and of the finish contour follow its corners; a
/// cycle roughs anew by itself.
[[nodiscard]] Done turn_anew(EditScene& scene, const ContourEdit& contour, std::size_t feature);
/// The bottom of a groove.
[[nodiscard]] Done deepen_turned(EditScene& scene, const SetDepth& depth, std::size_t feature);

}  // namespace kerf::features
