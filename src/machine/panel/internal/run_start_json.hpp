#pragma once

#include <string>
#include <vector>

#include "machine/panel/internal/journal_values.hpp"
#include "machine/panel/internal/run_start.hpp"

namespace kerf::machine {

// What a run begins with, as the object `start` of a journal. Both throw NoJournal.

[[nodiscard]] Json run_start_json(const RunStart& start);
[[nodiscard]] RunStart run_start_of(const Json& json, std::vector<std::string> library_folders);

/// The program with its text, wherever it is; its name is that of its file.
[[nodiscard]] Json program_json(const base::ProgramText& program);
[[nodiscard]] base::ProgramText program_in(const Json& object, const char* key);

}  // namespace kerf::machine
