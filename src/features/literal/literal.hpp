#pragma once

#include "features/path/recording.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// The layers, features and holes that the pattern of the rows shows. Linear in their number.
[[nodiscard]] LiteralTree recognise_literally(const Recording& recording);

}  // namespace kerf::features
