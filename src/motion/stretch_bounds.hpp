#pragma once

#include "base/path_jet.hpp"
#include "motion/cell_limits.hpp"
#include "motion/linkage.hpp"
#include "motion/stretch.hpp"

namespace kerf::motion {

/// What bounds the speed over a stretch: of the derivatives of the driven axes, and of how far they
/// lead the tip from its line, by what its samples show and a little more. `curvature` is that of
/// the tip's path.
[[nodiscard]] CellBounds bounds_of(const Stretch& stretch, const Linkage& linkage,
                                   double curvature);

/// The same at one sample of it, whose rates are determined, where the rest is as in `stretch`.
[[nodiscard]] CellBounds bounds_at(const base::PathJet& rates, const CellBounds& stretch);

}  // namespace kerf::motion
