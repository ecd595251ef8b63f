#pragma once

#include <optional>

#include "machine/panel/internal/live_core.hpp"

namespace kerf::machine {

/// Whether a key begins a run: what was before is not needed to make it again.
[[nodiscard]] bool begins_run(const Operation& key, const LiveCore& core);

/// The same key said in full, where it leaves something to how the machine stands.
[[nodiscard]] Operation in_full(Operation key, LiveCore& core);

/// Of a key that acts where the axes are, while the program has been read farther than that: what
/// is to come before the first block that they have not begun. Nothing: it acts now.
[[nodiscard]] std::optional<Operation> acts_on_axes(const Operation& key, LiveCore& core);

}  // namespace kerf::machine
