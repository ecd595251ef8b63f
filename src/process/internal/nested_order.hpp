#pragma once

#include <optional>
#include <vector>

#include "process/internal/flat_items.hpp"

namespace kerf::process::ordering {

/// An order in which an item and all that must be made before it are made without anything between
/// them: parts one after the other, each from its inside to its outline, the way between parts as
/// short as `search` makes it. Nothing where what is said of before does not come to such parts.
using Search = std::vector<Turn> (*)(const FlatItems& items, const Ends& ends);
[[nodiscard]] std::optional<std::vector<Turn>> nested_order(const FlatItems& items,
                                                            const Ends& ends, Search search);

}  // namespace kerf::process::ordering
