#pragma once

#include "stock/field/block_points.hpp"
#include "stock/field/lower_envelope.hpp"

namespace kerf::stock::field {

/// What rounding may do to a lower bound of a surface.
inline constexpr double kBoundSafety_mm = 1e-9;

/// A straight way seen from the side: the tip begins at z and rises by `slope` >= 0 per mm over
/// `length` mm.
struct StraightSlope {
  double z = 0;
  double slope = 0;
  double length = 0;
};

/// low[i] becomes the lowest surface that a piece of a tool leaves over a column at `along`,
/// √across2 beside the way, where that is lower.
void lower_by_piece(const StraightSlope& way, const EnvelopePiece& piece, const BlockValues& along,
                    const BlockValues& across2, BlockValues& low);

/// tip[i] + f(distance[i]); kNowhere beyond its reach.
void lowest_at(const LowerEnvelope& tool, const RowValues& distance, const RowValues& tip,
               RowValues& lowest);
/// low[i] becomes z + f(distance[i]) where that is lower.
void lower_level(const LowerEnvelope& tool, double z, const BlockValues& distance,
                 BlockValues& low);

}  // namespace kerf::stock::field
