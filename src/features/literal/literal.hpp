#pragma once

#include "features/path/allowance.hpp"
#include "features/path/recording.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// The layers, features and holes that the pattern of the rows shows, as far as the allowance goes.
/// Linear in their number.
[[nodiscard]] LiteralTree recognise_literally(const Recording& recording, Allowance& allowance);

}  // namespace kerf::features
