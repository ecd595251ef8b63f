#pragma once

#include "features/plan/internal/edit_scene.hpp"

namespace kerf::features {

/// Why a feature cannot have another tool: which others have this one.
[[nodiscard]] Done check_tool(EditScene& scene, std::uint32_t tool, const std::string& target);
/// Warns of tools whose last feature goes: their change and their opening stay in the program.
void tell_unused_tools(EditScene& scene);

}  // namespace kerf::features
