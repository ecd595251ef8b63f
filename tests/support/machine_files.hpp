#pragma once

#include <gtest/gtest.h>

#include <string>

#include "machine/definition/machine_definition.hpp"

namespace kerf::test {

/// An axis of a machine file; `more` are lines of it.
inline std::string axis(const std::string& name, bool rotary = false,
                        const std::string& more = {}) {
  return "[[axis]]\nname = \"" + name + "\"\nrotary = " + (rotary ? "true" : "false") +
         "\nvelocity = 6000\n" + more;
}

/// A file with the axes that its linkage needs; `more` begins in line 3.
inline std::string file_of(const std::string& type, const std::string& more) {
  std::string axes;
  if (type == "arm") axes = axis("T1", true) + axis("T2", true) + axis("T3", true) + axis("Z");
  if (type == "x-theta-z") axes = axis("X") + axis("C", true) + axis("Z");
  if (type == "head-ac") {
    axes = axis("X") + axis("Y") + axis("Z") + axis("A", true) + axis("C", true);
  }
  if (type == "cartesian" || type == "cartesian-step") axes = axis("X") + axis("Y");
  return "name = \"m\"\nkinematics.type = \"" + type + "\"\n" + more + axes;
}

inline machine::MachineDefinition machine_of(const std::string& type,
                                             const std::string& more = {}) {
  auto machine = machine::MachineDefinition::parse(file_of(type, more), "m.toml");
  EXPECT_TRUE(machine) << machine.error().message;
  return machine ? *machine : machine::MachineDefinition{};
}

}  // namespace kerf::test
