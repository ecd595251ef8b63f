#pragma once

#include <cstdint>
#include <vector>

#include "features/path/recording.hpp"
#include "features/tree/feature.hpp"

namespace kerf::features {

/// The rows of a layer that cut across, in their order.
[[nodiscard]] inline std::vector<std::uint32_t> rows_across(const Recording& recording,
                                                            const Layer& layer) {
  std::vector<std::uint32_t> rows;
  for (const Span& span : layer.cuts) {
    for (std::uint32_t row = span.first; row <= span.last; ++row) {
      if (recording.moves[row].cuts() && recording.goes_across(row)) rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace kerf::features
