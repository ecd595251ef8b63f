#pragma once

#include "features/plan/internal/edit_scene.hpp"

namespace kerf::features {

/// The contour of what is turned, as edits begin with it.
[[nodiscard]] ContourEdit turned_contour(const EditScene& scene, std::size_t feature);
/// What is turned gets this contour: blocks that go along it are those of the new one, passes end
/// as far from it as they did; those that would cut into it go, and where more is to be cut others
/// come in. A cycle roughs anew by itself.
[[nodiscard]] Done turn_anew(EditScene& scene, const ContourEdit& contour, std::size_t feature);
/// The bottom of a groove.
[[nodiscard]] Done deepen_turned(EditScene& scene, const SetDepth& depth, std::size_t feature);

}  // namespace kerf::features
