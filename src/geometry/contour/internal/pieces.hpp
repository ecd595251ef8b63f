#pragma once

#include <span>
#include <vector>

#include "geometry/contour/internal/piece.hpp"
#include "geometry/contour/internal/strand.hpp"

namespace kerf::contour {

/// The strands as pieces between points of the pool: arcs divided where their circle turns from
/// rising to falling and from left to right, what is no longer than kSame_mm left out.
[[nodiscard]] std::vector<Piece> pieces_of(std::span<const Strand> strands, PointPool& pool);

/// Pieces that are one (kSame_mm) become one, gone along as often as all of them; those that are
/// gone along as often backwards as forwards vanish.
void merge_equal(std::vector<Piece>& pieces);

}  // namespace kerf::contour
