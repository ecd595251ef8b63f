#pragma once

#include "features/path/allowance.hpp"
#include "features/path/blank.hpp"
#include "features/path/recording.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// Recognises what a lathe has machined, for a tree that has its operations. `blank`: its half
/// section in (z, radius), machine coordinates. What the allowance does not suffice for is told as
/// not recognised.
void recognise_turning(const Recording& recording, const Blank& blank, Allowance& allowance,
                       Tree& tree);

}  // namespace kerf::features
