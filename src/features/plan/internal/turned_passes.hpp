#pragma once

#include <vector>

#include "features/plan/internal/corner_shift.hpp"
#include "features/rewrite/planned_row.hpp"
#include "features/tree/feature.hpp"

namespace kerf::features {

/// Roughing passes in long hand for another contour (features-contract §7): each ends as far before
/// it as before the old one. Those that would cut into it go with their retract; where it lies
/// deeper others come in behind the last one, at its depth of cut. `visits`: of the passes, in
/// their order, none of them along the contour.
[[nodiscard]] std::vector<Stretch> passes_for(const Recording& recording, const TurnedPart& part,
                                              const contour::Contour& now,
                                              const std::vector<Span>& visits);

}  // namespace kerf::features
