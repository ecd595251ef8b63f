#pragma once

#include <optional>
#include <vector>

#include "process/internal/flat_items.hpp"

namespace kerf::process::ordering {

inline constexpr std::uint32_t kMostExact = 9;

/// The shortest order of at most kMostExact items that there is; nothing where it would take more
/// than a fixed amount of work. `known_mm`: what another order takes.
[[nodiscard]] std::optional<std::vector<Turn>> best_order(const FlatItems& items, const Ends& ends,
                                                          double known_mm);

}  // namespace kerf::process::ordering
