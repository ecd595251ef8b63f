#pragma once

#include "features/plan/internal/edit_scene.hpp"

namespace kerf::features {

/// Under G41 and G42 the control goes beside the contour by itself: the blocks along it are those
/// of the new contour, what leads there follows the end of its first element if that has moved.
[[nodiscard]] Editing<Stretch> contour_followed(const EditScene& scene, std::size_t feature,
                                                std::size_t layer, const LayerContours& contours);

/// Whether it is a ring along the inside of a contour under compensation: what stands in it is no
/// contour that a block goes along.
[[nodiscard]] bool leaves_what_stays(const Feature& feature);
/// The contours of a layer as they shall come back: what a ring cut along the inside of a contour
/// leaves standing follows that.
[[nodiscard]] LayerContours with_what_stays(const EditScene& scene, std::size_t feature,
                                            LayerContours contours);

}  // namespace kerf::features
