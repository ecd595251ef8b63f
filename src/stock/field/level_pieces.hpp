#pragma once

#include "stock/field/block_points.hpp"
#include "stock/field/lower_envelope.hpp"

namespace kerf::stock::field {

/// tip[i] + f(distance[i]) for the blocks of a row that are asked for; kNowhere beyond its reach.
void lowest_at(const LowerEnvelope& tool, const BlockGrid& grid, const RowValues& distance,
               const RowValues& tip, RowValues& lowest);
/// low[i] becomes z + f(distance[i]) where that is lower.
void lower_level(const LowerEnvelope& tool, float z, const BlockValues& distance, BlockValues& low);

}  // namespace kerf::stock::field
