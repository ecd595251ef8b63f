#pragma once

#include <vector>

#include "features/plan/edit_plan.hpp"

namespace kerf::features {

/// Makes a plan of edits: applies them in their order, lets the other layers follow, and cuts anew
/// what has changed (features-contract §5 to §8).
[[nodiscard]] Editing<EditPlan> plan_edits(const Recording& recording, const Tree& tree,
                                           const std::vector<Edit>& edits, bool allows_collision);

}  // namespace kerf::features
