#pragma once

#include "features/path/recording.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// Recognises what a recording has machined.
[[nodiscard]] Tree recognise(const Recording& recording);

}  // namespace kerf::features
