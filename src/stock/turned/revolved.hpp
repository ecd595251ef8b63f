#pragma once

#include <vector>

#include "geometry/contour/region.hpp"
#include "stock/sweep/piece.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock::turned {

/// What a region of the half plane (u = Z, v = ρ >= 0) goes through when it turns once about the
/// axis v = 0: mm³, -π∮ρ² dz round it. Lines and arcs in closed form (stock.md §3).
[[nodiscard]] double volume(const contour::Region& region);

/// The box about what it goes through; low > high of an empty region.
[[nodiscard]] Bounds bounds(const contour::Region& region);

/// What of it hangs together, the largest first; of equals that with the lower Z. The one that
/// reaches farthest to -Z is held: the chuck is there.
[[nodiscard]] std::vector<Piece> pieces(const contour::Region& region);

}  // namespace kerf::stock::turned
