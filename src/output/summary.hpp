#pragma once

#include <string>

#include "machine/virtual_machine.hpp"

namespace kerf::output {

/// JSON of the summary's members that outputs of the run tell; those that are empty are left out.
struct SummaryOfOutputs {
  std::string pattern;
  std::string post;
};

/// The summary of a run as one JSON object on one line (docs/command-line.md).
[[nodiscard]] std::string summary_json(machine::VirtualMachine& machine,
                                       const SummaryOfOutputs& outputs = {});

/// The same for people: a few lines of text.
[[nodiscard]] std::string summary_text(machine::VirtualMachine& machine);

/// What a person calls a file: its name without folders.
[[nodiscard]] std::string file_title(const std::string& path);

/// What a person calls the program of the machine: its name, else that of its file without folders.
[[nodiscard]] std::string program_title(machine::VirtualMachine& machine);

}  // namespace kerf::output
