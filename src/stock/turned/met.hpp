#pragma once

#include "geometry/contour/region.hpp"
#include "stock/sweep/outcome.hpp"

namespace kerf::stock::turned {

/// What a shrunk part of a tool has met counts where it is thicker than the touch tolerance along Z
/// and along ρ: the part itself is then deeper than twice that (stock.md §5).
[[nodiscard]] bool counts(const contour::Region& met, double touch_mm);

/// The deepest of its loops has a depth, the lesser of its sizes along Z and along ρ, and a place.
[[nodiscard]] Contact contact_of(const contour::Region& met);

}  // namespace kerf::stock::turned
