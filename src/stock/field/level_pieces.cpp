#include "stock/field/level_pieces.hpp"

#include <algorithm>

namespace kerf::stock::field {

void lowest_at(const LowerEnvelope& tool, const BlockGrid& grid, const RowValues& distance,
               const RowValues& tip, RowValues& lowest) {
  for (std::size_t i = grid.first_x; i < grid.end_x; ++i) {
    lowest[i] = tip[i] + static_cast<float>(tool.at(static_cast<double>(distance[i])));
  }
}

void lower_level(const LowerEnvelope& tool, float z, const BlockValues& distance,
                 BlockValues& low) {
  for (const EnvelopePiece& piece : tool.pieces()) {
    const auto reach = static_cast<float>(piece.s1);
    for (std::size_t i = 0; i < kBlockCells; ++i) {
      if (distance[i] > reach) continue;
      low[i] = std::min(low[i], z + static_cast<float>(piece.at(static_cast<double>(distance[i]))));
    }
  }
}

}  // namespace kerf::stock::field
