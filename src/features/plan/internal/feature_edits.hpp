#pragma once

#include "features/plan/internal/edit_scene.hpp"
#include "features/plan/internal/feature_wish.hpp"

namespace kerf::features {

/// What one edit adds to what its feature shall become. Origins are checked already.
[[nodiscard]] Done wish_of_feature(EditScene& scene, const Edit& edit, std::size_t feature,
                                   FeatureWish& wish);

/// Makes the rows of a feature what is wished: contours, layers above and below, depth, place,
/// feeds, tool.
[[nodiscard]] Done make_feature(EditScene& scene, std::size_t feature, FeatureWish& wish);

}  // namespace kerf::features
