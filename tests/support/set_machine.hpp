#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "machine/definition/machine_definition.hpp"

namespace kerf::test {

/// Keys of a machine file with their values.
using MachineSettings = std::vector<std::pair<std::string, std::string>>;

/// A built-in machine with some keys set.
inline machine::MachineDefinition machine_with(const std::string& name,
                                               const MachineSettings& settings = {}) {
  auto machine = *machine::find_machine(name);
  for (const auto& [key, value] : settings) EXPECT_TRUE(machine.set(key, value)) << key;
  return machine;
}

}  // namespace kerf::test
