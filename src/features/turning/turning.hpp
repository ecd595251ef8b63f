#pragma once

#include "features/path/blank.hpp"
#include "features/path/recording.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// Recognises what a lathe has machined, for a tree that has its operations. `blank`: its half
/// section in (z, radius), machine coordinates.
void recognise_turning(const Recording& recording, const Blank& blank, Tree& tree);

}  // namespace kerf::features
