#pragma once

#include <vector>

#include "features/plan/internal/edit_scene.hpp"
#include "geometry/contour/region.hpp"

namespace kerf::features {

/// EDIT_UNDERCUT: no tool cuts below what stands, so each layer must hold the one below it.
/// `regions`: of all layers of the feature.
[[nodiscard]] Done check_undercut(EditScene& scene, std::size_t feature,
                                  const std::vector<contour::Region>& regions);
/// EDIT_COLLIDES: what a layer cuts more lies in another feature at its height.
[[nodiscard]] Done check_collision(EditScene& scene, std::size_t feature, std::size_t layer,
                                   const contour::Region& before, const contour::Region& now);

}  // namespace kerf::features
