#pragma once

#include <CLI/CLI.hpp>

#include "face/cli/commands.hpp"

namespace kerf::cli {

/// Adds the options that say what lies on the table and which checks count. The options must
/// outlive the application.
void add_table(CLI::App& app, TableOptions& options);
/// Adds the command `stock`. The options must outlive the application.
void add_stock(CLI::App& app, StockOptions& options);

}  // namespace kerf::cli
