#pragma once

#include <tl/expected.hpp>

#include "features/rewrite/regenerate.hpp"

namespace kerf::features {

/// Whether a layer was cleared in lines or turns that do not close, whatever rounds it has beside.
[[nodiscard]] bool is_in_lines_or_turns(const Recording& recording, const NewLayer& wanted);

/// The rows of such a layer for its new contours.
[[nodiscard]] tl::expected<NewRows, CannotCut> in_lines_or_turns(const Recording& recording,
                                                                 const NewLayer& wanted);

}  // namespace kerf::features
