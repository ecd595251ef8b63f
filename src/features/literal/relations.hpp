#pragma once

#include <vector>

#include "features/literal/scan_lines.hpp"
#include "features/path/recording.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// How the outer paths of two literal features lie to each other: contains or partial.
struct LiteralRelation {
  std::size_t first = 0;  ///< places among the features
  std::size_t second = 0;
  ScanRelation relation = ScanRelation::partial;
};

/// Of the first 64 features, whose outer paths are the longest loops of their first layers.
[[nodiscard]] std::vector<LiteralRelation> relations_of(const Recording& recording,
                                                        const LiteralTree& literal);

}  // namespace kerf::features
