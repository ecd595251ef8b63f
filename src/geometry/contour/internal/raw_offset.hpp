#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/contour/internal/strand.hpp"

namespace kerf::contour {

/// An edge of a closed chain, and the owner of what goes round the corner at its end.
struct Link {
  Edge edge;
  std::uint32_t corner_owner = 0;
};

/// Adds the raw offset of a closed chain at `distance` to its right (to its left, if < 0): it
/// crosses itself, but its windings tell what is within that distance.
///
///            ╭──────────╮            Take for each edge the strip that its normals sweep, for each
///      convex│  strip   │ convex     corner that opens to this side the sector between the strips.
///            │          │            Each is gone round once in one sense, so the sum of all and
///            of
///   ─────────●══════════●──────      the chain itself counts, in each point, how many of them hold
///                                    it: it is not 0 just where one does. The sides of strips that
///   ─────────●          ●──────      meet go forth and back and vanish; where a corner closes to
///     strip  └──>v<─────┘  strip     this side they overlap, and the raw offset leads over the
///             concave corner         corner v itself. What is near is in a strip or a sector: its
///                                    nearest point on the chain is the foot of a normal, or a
///                                    corner.
///
/// Normals of an arc on its inner side end in its centre at the latest: beyond, the nearest point
/// is another one. The chain itself is not added: where it is the border of a region, its winding
/// is in that of the offset, as sides and strips cancel.
void add_raw_offset(std::vector<Strand>& strands, std::span<const Link> chain, double distance);

}  // namespace kerf::contour
