#pragma once

#include <vector>

#include "features/plan/edit_plan.hpp"
#include "features/rewrite/old_ways.hpp"

namespace kerf::features {

/// What somebody lets happen all the same.
struct EditAllowances {
  bool collision = false;
  bool rest = false;
};

/// Makes a plan of edits: applies them in their order, lets the other layers follow, and cuts anew
/// what has changed (features-contract §5 to §8). `ways`: of this recording.
[[nodiscard]] Editing<EditPlan> plan_edits(const Recording& recording, const Tree& tree,
                                           OldWays& ways, const std::vector<Edit>& edits,
                                           EditAllowances allowed);

}  // namespace kerf::features
