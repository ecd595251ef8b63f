#pragma once

#include <span>
#include <vector>

#include "geometry/contour/internal/planar_map.hpp"
#include "geometry/contour/internal/strand.hpp"

namespace kerf::contour {

/// The simple loops round the faces that are taken, with these on the left, the largest part of
/// each strand as one edge and its number as the owner. Loops of less area than kNoArea_mm2 are
/// left out.
[[nodiscard]] std::vector<Contour> joined_loops(const PlanarMap& map,
                                                const std::vector<bool>& is_taken,
                                                std::span<const Strand> strands);

/// Replaces numbers of strands by their owners, and joins what then goes on straight or on one
/// circle with the same owner.
void give_owners(Contour& loop, std::span<const Strand> strands);

}  // namespace kerf::contour
