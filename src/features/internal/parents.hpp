#pragma once

#include "features/tree/tree.hpp"

namespace kerf::features {

/// Gives features and holes the smallest feature that holds them for a parent: they begin on its
/// floor, stand on one of its islands, or cross it. Those that have one keep it.
void find_parents(Tree& tree);

}  // namespace kerf::features
