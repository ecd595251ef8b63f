#pragma once

#include "face/cli/commands.hpp"

namespace kerf::cli {

/// `kerf run --dialect pattern`: a replay with the options that a pattern knows. Any other option
/// is wrong usage.
[[nodiscard]] ExitStatus run_pattern(const RunOptions& options);

}  // namespace kerf::cli
