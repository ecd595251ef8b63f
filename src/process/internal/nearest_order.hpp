#pragma once

#include <vector>

#include "process/internal/flat_items.hpp"

namespace kerf::process::ordering {

/// Always the item that begins nearest to where the last one ended, of those that may be made.
/// Items that wait for each other are made in the order of the list, as if they did not.
[[nodiscard]] std::vector<Turn> nearest_order(const FlatItems& items, const Ends& ends);

}  // namespace kerf::process::ordering
