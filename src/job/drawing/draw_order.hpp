#pragma once

#include <map>
#include <string>
#include <vector>

#include "drawing/canvas.hpp"
#include "machine/definition/machine_definition.hpp"
#include "process/material.hpp"
#include "process/recipe.hpp"

namespace kerf::job {

/// What is to be made of which drawings, as a value: the same order is the same plan.
struct DrawOrder {
  std::vector<std::string> drawings;  ///< files, laid over each other, or shapes: "lens:oval:50,40"
  process::Recipe recipe;
  drawing::Reading reading;
  machine::MachineDefinition definition;
  std::vector<process::Material> materials;        ///< besides those that Kerf knows
  std::map<std::string, std::string> variables{};  ///< of texts
  double max_seconds = 60;                         ///< for reading and planning
};

}  // namespace kerf::job
