#pragma once

#include "features/path/allowance.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// Gives features and holes the smallest feature that holds them for a parent: they begin on its
/// floor, stand on one of its islands, or cross it. Those that have one keep it. None is looked for
/// when the allowance is over.
void find_parents(Tree& tree, Allowance& allowance);

}  // namespace kerf::features
