#pragma once

#include "features/milling/workshop.hpp"

namespace kerf::features {

/// Makes the features and holes of the tree of what the workshop has found. What the allowance does
/// not suffice for is not recognised.
void finish(const Recording& recording, Workshop& shop, Allowance& allowance, Tree& tree);

}  // namespace kerf::features
