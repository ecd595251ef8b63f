#pragma once

#include <CLI/CLI.hpp>

#include "face/cli/commands.hpp"

namespace kerf::cli {

/// `kerf draw`. The options must outlive the application.
void add_draw(CLI::App& app, DrawOptions& options);

}  // namespace kerf::cli
