#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

#include "face/cli/commands.hpp"

namespace kerf::cli {

/// Whether a command has --jobs for the threads that cut, or for something else.
enum class CuttingJobs : std::uint8_t { option, no_option };
/// Adds those of the options that say what lies on the table, and nothing else.
void add_blank(CLI::App& app, TableOptions& options);
/// Adds the options that say what lies on the table and which checks count. The options must
/// outlive the application.
void add_table(CLI::App& app, TableOptions& options, CuttingJobs jobs = CuttingJobs::option);
/// Adds the command `stock`. The options must outlive the application.
void add_stock(CLI::App& app, StockOptions& options);

}  // namespace kerf::cli
