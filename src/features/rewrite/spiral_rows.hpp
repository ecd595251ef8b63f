#pragma once

#include <tl/expected.hpp>

#include "features/rewrite/regenerate.hpp"

namespace kerf::features {

/// The rows of a round pocket that a spiral clears, for another diameter or place: the turns stay
/// as far as they go, others follow as far apart, and the round along the wall is as it was.
[[nodiscard]] tl::expected<NewRows, CannotCut> regenerated_as_spiral(const Recording& recording,
                                                                     const NewLayer& wanted,
                                                                     Span visit,
                                                                     double tool_radius);

}  // namespace kerf::features
