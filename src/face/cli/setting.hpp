#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "machine/definition/machine_definition.hpp"

namespace kerf::cli {

/// A word "KEY=VALUE" of the command line; the value may contain '='.
struct Setting {
  std::string key;
  std::string value;
};

/// Failure (usage) names the option.
[[nodiscard]] base::Outcome<Setting> split_setting(const std::string& text,
                                                   const std::string& option);

/// Sets keys of the machine file, as --machine-set has them. Failure (usage).
[[nodiscard]] base::Outcome<void> set_machine_keys(const std::vector<std::string>& keys,
                                                   machine::MachineDefinition& definition);

}  // namespace kerf::cli
