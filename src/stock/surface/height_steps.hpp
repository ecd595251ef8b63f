#pragma once

#include "stock/field/columns.hpp"
#include "stock/surface/surface.hpp"

namespace kerf::stock::surface {

/// A height field as it is: each column a post with a flat top and bottom. Heights are rounded to a
/// power of two that float32 can still tell apart at the size of the part, some 0.1 µm. Posts that
/// only touch at an edge are two things, apart by a thousandth of a cell.
[[nodiscard]] Surface height_steps(const field::Columns& columns);

}  // namespace kerf::stock::surface
