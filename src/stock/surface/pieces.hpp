#pragma once

#include <vector>

#include "stock/surface/surface.hpp"

namespace kerf::stock::surface {

/// What hangs together by triangles, each with the cavities in it; the largest first, of equals the
/// one whose points come first. Nothing of a surface without volume.
[[nodiscard]] std::vector<Surface> pieces_of(const Surface& surface);

}  // namespace kerf::stock::surface
