#pragma once

#include "features/plan/internal/edit_scene.hpp"

namespace kerf::features {

/// Under G41 and G42 the control goes beside the contour by itself: its corners alone move.
[[nodiscard]] Editing<Stretch> vertices_followed(const EditScene& scene, std::size_t feature,
                                                 std::size_t layer, const LayerContours& contours);
/// An edit of what is turned: ends of passes and of the finish contour follow its corners; a cycle
/// roughs anew by itself.
[[nodiscard]] Done edit_turned(EditScene& scene, const Edit& edit, std::size_t feature);

}  // namespace kerf::features
