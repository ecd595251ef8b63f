#pragma once

#include <cstddef>
#include <vector>

#include "drawing/cleaning.hpp"

namespace kerf::drawing {

/// Of chains that have one layer and the same ends and bulges, from whichever end or, closed, from
/// whichever vertex on, the first ones.
[[nodiscard]] std::vector<Chain> without_duplicates(std::vector<Chain> chains,
                                                    const Drawing& drawing, double same_mm);

}  // namespace kerf::drawing
