#pragma once

#include <vector>

#include "features/tree/tree.hpp"

namespace kerf::features {

/// Puts holes of the same steps that were made one after the other into patterns: circle, grid,
/// line, or a list; each hole is in one at most.
void find_patterns(Tree& tree);

}  // namespace kerf::features
