#pragma once

#include "base/axes.hpp"
#include "motion/cell_limits.hpp"
#include "motion/linkage.hpp"
#include "motion/stretch.hpp"

namespace kerf::motion {

/// What bounds the speed over a stretch: of the derivatives of the driven axes, and of how far they
/// lead the tip from its line, by what its samples show and a little more. `curvature` is that of
/// the tip's path, `acceleration` what the driven axes can do.
[[nodiscard]] CellBounds bounds_of(const Stretch& stretch, const Linkage& linkage, double curvature,
                                   const base::AxisVector& acceleration);

/// The same at one sample of it, whose rates are determined; the curvature is as in `stretch`.
[[nodiscard]] CellBounds bounds_at(const JointSample& sample, const Linkage& linkage,
                                   const CellBounds& stretch, const base::AxisVector& acceleration);

}  // namespace kerf::motion
