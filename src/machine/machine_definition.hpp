#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "control/axis_setup.hpp"
#include "control/parameters.hpp"

namespace kerf::machine {

/// Languages that programs are written in. Kerf reads the first one; the others have their names.
inline constexpr std::array<std::string_view, 5> kDialects = {"fanuc-mill", "fanuc-lathe",
                                                              "laser-basic", "teach", "pattern"};

/// A machine as its TOML file describes it.
struct MachineDefinition {
  std::string name;
  std::string description;
  std::string dialect;  ///< one of kDialects
  control::AxisSetup axes;
  control::Parameters parameters;

  /// Reads a definition. Failure (input): what is wrong, with the line; every unknown key is wrong.
  [[nodiscard]] static base::Outcome<MachineDefinition> parse(std::string_view toml,
                                                              const std::string& source);

  /// `--machine-set`: axis.X.velocity, axis.X.acceleration, axis.X.jerk. Failure (usage).
  [[nodiscard]] base::Outcome<void> set(std::string_view key, std::string_view value);
};

/// A machine that comes with Kerf.
struct BuiltinMachine {
  std::string_view name;
  std::string_view toml;
};
[[nodiscard]] const std::vector<BuiltinMachine>& builtin_machines();

/// The built-in machine of this name, or the machine file at this path. Failure (usage): no machine
/// has this name; (input): the file cannot be read or is wrong.
[[nodiscard]] base::Outcome<MachineDefinition> find_machine(const std::string& name_or_path);

}  // namespace kerf::machine
