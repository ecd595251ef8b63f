#pragma once

#include "features/plan/internal/edit_scene.hpp"

namespace kerf::features {

/// Under G41 and G42 the control goes beside the contour by itself: its corners alone move.
[[nodiscard]] Editing<Stretch> vertices_followed(const EditScene& scene, std::size_t feature,
                                                 std::size_t layer, const LayerContours& contours);

}  // namespace kerf::features
