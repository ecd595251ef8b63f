#pragma once

#include "features/merge/merge_state.hpp"

namespace kerf::features {

/// Changes the words of a block so that it commands its rows, whatever it inherits now. `old`: what
/// it inherited. Whether something had to be changed.
bool follow_block(MergeState& state, const BlockRows& rows, const Inherited& old);

}  // namespace kerf::features
