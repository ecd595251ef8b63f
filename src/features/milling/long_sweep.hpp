#pragma once

#include <optional>
#include <vector>

#include "features/path/allowance.hpp"
#include "geometry/contour/region.hpp"

namespace kerf::features {

/// What a disc sweeps along open paths, all together. Where many edges lie near to each other it is
/// made part by part, and the parts are put together: what goes over one place a thousand times
/// costs no more than the borders of its parts. Nothing: the allowance is over.
[[nodiscard]] std::optional<contour::Region> swept_along(const std::vector<contour::Contour>& paths,
                                                         double radius, Allowance& allowance);

}  // namespace kerf::features
