#pragma once

#include <optional>
#include <vector>

#include "features/path/allowance.hpp"
#include "geometry/contour/region.hpp"

namespace kerf::features {

/// The union of many regions, some at a time: where they lie over each other many times it costs no
/// more than their borders. Nothing: the allowance is over.
[[nodiscard]] std::optional<contour::Region> united(std::vector<contour::Region> parts,
                                                    Allowance& allowance);

}  // namespace kerf::features
