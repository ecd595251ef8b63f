#pragma once

#include "features/path/block_facts.hpp"
#include "features/path/recording.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// Tells of each feature and hole of a tree where its blocks come from and what an edit of its
/// contour would be, and collects the calls that led to them. Blocks that also set something up are
/// part of no visit.
void find_origins(const Recording& recording, BlockReader& reader, Tree& tree);

}  // namespace kerf::features
