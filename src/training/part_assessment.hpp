#pragma once

#include <stop_token>
#include <string>

#include "machine/definition/machine_definition.hpp"
#include "training/assessment.hpp"
#include "training/exercise.hpp"

namespace kerf::training {

/// Holds the part that the program makes against that of the solution: what is left too much, what
/// is cut away too much, and what was met that should not have been. Otherwise as assess().
/// Precondition: the exercise has a part.
[[nodiscard]] base::Outcome<Assessment> assess_part(const Exercise& exercise,
                                                    const machine::MachineDefinition& definition,
                                                    const std::string& program,
                                                    const std::stop_token& unwanted);

}  // namespace kerf::training
