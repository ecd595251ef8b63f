#pragma once

#include <string>

#include "base/result.hpp"
#include "control/core/memory.hpp"

namespace kerf::machine {

/// The control's permanent memory as a file: #500 to #999, work and tool offsets, part counts,
/// variable names. Values in mm, in the machine's order of axes.

/// Reads `path` into `memory`. A file that does not exist leaves it as it is. Failure (input): the
/// file is not a state file; nothing of it is taken over then.
[[nodiscard]] base::Outcome<void> read_state(const std::string& path, control::Memory& memory);

/// Writes `memory` to `path` so that after a crash or power loss at any moment either the old file
/// or the new one is there. Failure (output).
[[nodiscard]] base::Outcome<void> write_state(const std::string& path,
                                              const control::Memory& memory);

/// The same as text, for what holds a memory among other things. Failure (input): this is none.
[[nodiscard]] std::string state_text(const control::Memory& memory);
[[nodiscard]] base::Outcome<void> take_state(const std::string& text, control::Memory& memory);

}  // namespace kerf::machine
