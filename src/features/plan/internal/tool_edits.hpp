#pragma once

#include "features/plan/internal/edit_scene.hpp"
#include "features/plan/internal/feature_wish.hpp"

namespace kerf::features {

/// Plans other tools: all that an operation cuts must have the same one (features-contract §8.7).
[[nodiscard]] Done change_tools(EditScene& scene, const EditWishes& wishes);
/// A tool whose last feature goes stays in the program, and is told.
void tell_unused_tools(EditScene& scene);

}  // namespace kerf::features
