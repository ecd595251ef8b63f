#pragma once

#include <CLI/CLI.hpp>

#include "base/result.hpp"
#include "face/cli/commands.hpp"

namespace kerf::cli {

/// Adds the command `edit`. The options must outlive the application.
void add_edit(CLI::App& app, EditOptions& options);

/// Failure (usage): what is asked for does not go together.
[[nodiscard]] base::Outcome<void> check_edit(const EditOptions& options);

}  // namespace kerf::cli
