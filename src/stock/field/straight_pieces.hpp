#pragma once

#include "stock/field/block_points.hpp"
#include "stock/field/lanes.hpp"
#include "stock/field/lower_envelope.hpp"

namespace kerf::stock::field {

/// By how much floats may move the surface, mm, over a leg and a tool of this size together.
constexpr double bound_safety(double size_mm) { return 1e-4 + 1e-6 * size_mm; }

/// A straight way seen from the side: the tip begins at z and rises by `slope` >= 0 per mm over
/// `length` mm.
struct StraightSlope {
  float z = 0;
  float slope = 0;
  float length = 0;
};

/// low[i] becomes the lowest surface that a piece of a tool leaves over a column at `along`,
/// √across2 beside the way, where that is lower.
void lower_by_piece(const StraightSlope& way, const EnvelopePiece& piece, const BlockValues& along,
                    const BlockValues& across2, BlockValues& low);

/// tip[i] + f(distance[i]); kNowhere beyond its reach.
void lowest_at(const LowerEnvelope& tool, const RowValues& distance, const RowValues& tip,
               RowValues& lowest);
/// low[i] becomes z + f(distance[i]) where that is lower.
void lower_level(const LowerEnvelope& tool, float z, const BlockValues& distance, BlockValues& low);

}  // namespace kerf::stock::field
