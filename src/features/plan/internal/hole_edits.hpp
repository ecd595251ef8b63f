#pragma once

#include "features/plan/internal/edit_scene.hpp"

namespace kerf::features {

// Edits of holes and of lists of holes.
[[nodiscard]] Done move_hole(EditScene& scene, contour::Vec2 to, std::size_t hole);
[[nodiscard]] Done set_hole_depth(EditScene& scene, double z, std::size_t hole);
[[nodiscard]] Done remove_hole(EditScene& scene, std::size_t hole);
/// Behind the last hole of the list.
[[nodiscard]] Done add_hole(EditScene& scene, contour::Vec2 at, std::size_t pattern);

}  // namespace kerf::features
