#pragma once

#include <CLI/CLI.hpp>

#include "face/cli/commands.hpp"

namespace kerf::cli {

/// Adds the command `stock`. The options must outlive the application.
void add_stock(CLI::App& app, StockOptions& options);

}  // namespace kerf::cli
