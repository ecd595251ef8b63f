#pragma once

#include <vector>

#include "geometry/contour/internal/piece.hpp"

namespace kerf::contour {

/// Breaks all pieces at all points of the pool that lie on them (kSame_mm), after adding to the
/// pool where they cross and touch; pieces that are then one are merged. What comes out meets in
/// points of the pool alone, as far as the tolerance tells.
[[nodiscard]] std::vector<Piece> broken(std::vector<Piece> pieces, PointPool& pool);

}  // namespace kerf::contour
