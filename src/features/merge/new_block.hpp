#pragma once

#include "features/merge/merge_state.hpp"

namespace kerf::features {

/// Puts a block that commands a new row behind the one that was written last.
void insert_block(MergeState& state, const PlannedRow& row);

}  // namespace kerf::features
