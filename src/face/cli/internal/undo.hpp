#pragma once

#include "face/cli/commands.hpp"

namespace kerf::cli {

/// Takes back the edit that a report tells of. Nothing is run.
[[nodiscard]] ExitStatus undo_edit(const EditOptions& options);

}  // namespace kerf::cli
