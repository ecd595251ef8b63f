#pragma once

#include <vector>

#include "stock/dexel/tri_dexel.hpp"
#include "stock/sweep/piece.hpp"

namespace kerf::stock::dexel {

/// What hangs together of the dexels of one grid: intervals of neighbours that overlap. The largest
/// first, of equals the one with the smaller X, Y and Z; the volume is that of this grid. Held is
/// what reaches the bottom of the box to within a cell.
[[nodiscard]] std::vector<Piece> pieces_of(const TriDexel& dexels, int grid, double bottom_mm);

}  // namespace kerf::stock::dexel
