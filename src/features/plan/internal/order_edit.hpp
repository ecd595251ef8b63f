#pragma once

#include "features/plan/internal/edit_scene.hpp"

namespace kerf::features {

/// The visits of a feature or hole go before, or behind, those of another of the same tool.
[[nodiscard]] Done change_order(EditScene& scene, const ChangeOrder& order,
                                const std::string& target);

}  // namespace kerf::features
