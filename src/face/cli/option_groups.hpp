#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "face/cli/commands.hpp"

namespace kerf::cli {

// What several commands have on their command lines. What options go to must outlive the
// application.

// CLI11's own sentences about numbers print the largest double in full.
[[nodiscard]] CLI::Validator not_negative();
[[nodiscard]] CLI::Validator whole_number();

/// One value a time: `--set A B` is no way to write two.
CLI::Option* repeated(CLI::Option* option);

/// Whether the command runs patterns of the engraving arm.
enum class Patterns : std::uint8_t { run, not_run };

void add_machine(CLI::App& app, std::string& machine, std::string& dialect, Patterns patterns);
void add_preparation(CLI::App& run, RunOptions& options, Patterns patterns);
void add_max_seconds(CLI::App& app, double& seconds);
void add_budget(CLI::App& app, double& seconds, std::uint64_t& motions);
void add_diagnostics(CLI::App& app, DiagnosticFormat& diagnostics);

}  // namespace kerf::cli
