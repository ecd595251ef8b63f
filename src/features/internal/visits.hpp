#pragma once

#include "features/path/block_facts.hpp"
#include "features/path/recording.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// Tells each operation from where to where its features and holes reach.
void tell_visits(Tree& tree);

/// Takes from the visits of features and holes the blocks at their ends that also set something up:
/// a tool, a spindle, a mode. They belong to no feature.
void trim_visits(const Recording& recording, BlockReader& reader, Tree& tree);

}  // namespace kerf::features
