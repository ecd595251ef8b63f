#pragma once

#include <tl/expected.hpp>

#include "features/rewrite/regenerate.hpp"

namespace kerf::features {

/// The rows of a layer that is cleared in parallel lines, one way or there and back: lines of the
/// same direction, from the same side, as far apart, with rounds along the walls where the old one
/// has them (features-contract §7).
[[nodiscard]] tl::expected<NewRows, CannotCut> regenerated_in_lines(const Recording& recording,
                                                                    const NewLayer& wanted,
                                                                    Span visit, double tool_radius);

}  // namespace kerf::features
