#pragma once

#include <cstdint>

#include "geometry/contour/region.hpp"
#include "stock/dexel/shape.hpp"

namespace kerf::stock::turnmill {

/// What a region of the half plane (u = Z, v = ρ >= 0) goes through when it turns once about Z, as
/// dexels see it: exact along each of them. Faces have the owners of their edges for motions; those
/// of owners below `first_motion` are borders, beyond which there is none of the part.
[[nodiscard]] dexel::Shape revolved_shape(const contour::Region& region,
                                          std::uint32_t first_motion);

}  // namespace kerf::stock::turnmill
