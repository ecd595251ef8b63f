#pragma once

#include "face/cli/commands.hpp"

namespace kerf {

/// `kerf serve`: the panel for a browser, until a signal ends it.
[[nodiscard]] cli::ExitStatus serve(const cli::ServeOptions& options);

}  // namespace kerf
