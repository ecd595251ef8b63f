#pragma once

#include "base/program_text.hpp"
#include "base/result.hpp"
#include "face/server/store/library.hpp"
#include "face/server/store/machine_store.hpp"

namespace kerf::server {

/// The text of a program as the machine runs it: of a pattern its listing. Waits for the disk.
[[nodiscard]] base::Outcome<base::ProgramText> text_of(const Library& library,
                                                       const LoadedProgram& program,
                                                       const machine::MachineDefinition& machine);

}  // namespace kerf::server
