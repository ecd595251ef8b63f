#pragma once

#include <string>

#include "machine/virtual_machine.hpp"

namespace kerf::output {

/// The summary of a run as one JSON object on one line (docs/command-line.md).
[[nodiscard]] std::string summary_json(machine::VirtualMachine& machine);

/// The same for people: a few lines of text.
[[nodiscard]] std::string summary_text(machine::VirtualMachine& machine);

/// What a person calls the program of the machine: its name, else that of its file without folders.
[[nodiscard]] std::string program_title(machine::VirtualMachine& machine);

}  // namespace kerf::output
