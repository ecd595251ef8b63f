#pragma once

#include <array>
#include <cstddef>

#include "base/axes.hpp"
#include "base/path_jet.hpp"
#include "planner/cell_limits.hpp"
#include "planner/linkage.hpp"
#include "planner/stretch.hpp"

namespace kerf::planner {

/// At each sample of a stretch; 0 where its rates are not determined.
using StretchBends = std::array<LinkageBend, 3>;
/// `acceleration`: what the driven axes can do.
[[nodiscard]] StretchBends bends_of(const Stretch& stretch, const Linkage& linkage,
                                    const base::AxisVector& acceleration);

/// What bounds the speed over a stretch: of the derivatives of the driven axes, and of how far they
/// lead the tip from its line, by what its samples show and a little more. `curvature` is that of
/// the tip's path.
[[nodiscard]] CellBounds bounds_of(const Stretch& stretch, const StretchBends& bends,
                                   double curvature, std::size_t axes);

/// The same at one sample of it, whose rates are determined; the rest is as in `stretch`.
[[nodiscard]] CellBounds bounds_at(const base::JointJet& rates, const LinkageBend& bend,
                                   const CellBounds& stretch);

}  // namespace kerf::planner
