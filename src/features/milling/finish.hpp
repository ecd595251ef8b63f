#pragma once

#include "features/milling/workshop.hpp"

namespace kerf::features {

/// Makes the features and holes of the tree of what the workshop has found.
void finish(const Recording& recording, Workshop& shop, Tree& tree);

}  // namespace kerf::features
