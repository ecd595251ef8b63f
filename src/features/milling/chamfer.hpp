#pragma once

#include "features/milling/classify.hpp"

namespace kerf::features {

/// Whether a cone breaks an edge of an earlier feature: its path runs beside one at one distance.
/// Then the feature gets its parent and its width, the horizontal leg at the edge.
[[nodiscard]] bool take_chamfer(const Neighbourhood& around, Draft& draft);

}  // namespace kerf::features
