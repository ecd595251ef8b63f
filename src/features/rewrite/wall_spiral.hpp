#pragma once

#include <tl/expected.hpp>

#include "features/rewrite/regenerate.hpp"

namespace kerf::features {

/// The rows of a pocket of straight walls that a spiral along them clears: each row runs beside a
/// wall, and with each turn it is as much farther from it as before.
[[nodiscard]] tl::expected<NewRows, CannotCut> regenerated_along_walls(const Recording& recording,
                                                                       const NewLayer& wanted,
                                                                       Span visit,
                                                                       double tool_radius);

}  // namespace kerf::features
