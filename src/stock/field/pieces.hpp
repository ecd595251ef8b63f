#pragma once

#include <vector>

#include "stock/field/columns.hpp"
#include "stock/sweep/piece.hpp"

namespace kerf::stock::field {

/// What hangs together: columns side by side whose material overlaps along Z. The largest first, of
/// equals the one with the smaller X and Y; what touches the bottom of the box is held.
[[nodiscard]] std::vector<Piece> pieces_of(const Columns& columns);

}  // namespace kerf::stock::field
