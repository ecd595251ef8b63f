#pragma once

#include "features/merge/merge_state.hpp"

namespace kerf::features {

/// Takes the lines of a loop out, or makes the block of a call a comment; what is written next
/// stands there. Refuses what would be lost: functions, and variables that are read elsewhere.
void begin_writing_out(MergeState& state, const Stretch& stretch);

}  // namespace kerf::features
