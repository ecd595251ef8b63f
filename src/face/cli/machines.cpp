#include <fmt/format.h>

#include <cstdio>

#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "machine/definition/machine_definition.hpp"

namespace kerf::cli {

ExitStatus machines(const std::string& name) {
  for (const machine::BuiltinMachine& builtin : machine::builtin_machines()) {
    if (name.empty()) {
      const auto definition =
          machine::MachineDefinition::parse(builtin.toml, std::string(builtin.name));
      fmt::print("{:<16}{}\n", builtin.name,
                 definition ? definition->description : definition.error().message);
    } else if (name == builtin.name) {
      fmt::print("{}", builtin.toml);
      return ExitStatus::well;
    }
  }
  if (name.empty()) return ExitStatus::well;
  return fail({base::Failure::Kind::usage,
               "there is no built-in machine " + name + "; `kerf machines` lists them"});
}

}  // namespace kerf::cli
