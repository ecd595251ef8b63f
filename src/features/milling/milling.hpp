#pragma once

#include "features/path/allowance.hpp"
#include "features/path/blank.hpp"
#include "features/path/recording.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// Recognises what a mill has cut by what its tools have swept: features, holes and what is not
/// recognised, for a tree that has its operations. `blank` in machine coordinates. What the
/// allowance does not suffice for is told as not recognised.
void recognise_milling(const Recording& recording, const Blank& blank, Allowance& allowance,
                       Tree& tree);

}  // namespace kerf::features
