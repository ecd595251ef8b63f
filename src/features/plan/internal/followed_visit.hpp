#pragma once

#include "features/plan/internal/edit_scene.hpp"

namespace kerf::features {

/// Under G41 and G42 the control goes beside the contour by itself: the blocks along it are those
/// of the new contour, what leads there follows the end of its first element if that has moved.
[[nodiscard]] Editing<Stretch> contour_followed(const EditScene& scene, std::size_t feature,
                                                std::size_t layer, const LayerContours& contours);

}  // namespace kerf::features
