#pragma once

#include <string>
#include <variant>
#include <vector>

#include "face/cli/commands.hpp"

namespace kerf::cli {

struct MachinesOptions {
  std::string name;  ///< empty: list all
};

struct MaterialsOptions {
  std::string name;  ///< empty: list all
};

/// A text that answers the command line: help, version. Goes to standard output.
struct Answer {
  std::string text;
};

/// What a command line asks for.
using Request = std::variant<RunOptions, TimeOptions, StockOptions, FeaturesOptions, EditOptions,
                             CheckOptions, DrawOptions, PatternOptions, ReplayOptions,
                             MachinesOptions, ServeOptions, ToolsOptions, MaterialsOptions, Answer>;

/// Reads the words behind `kerf`. Failure (usage): one sentence.
[[nodiscard]] base::Outcome<Request> parse_arguments(const std::vector<std::string>& words);

}  // namespace kerf::cli
