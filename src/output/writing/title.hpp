#pragma once

#include <string>

namespace kerf::output {

/// What a person calls a file: its name without folders.
[[nodiscard]] std::string file_title(const std::string& path);

/// What a person calls a program: its name, else that of its file without folders.
[[nodiscard]] std::string program_title(const std::string& name, const std::string& file);

}  // namespace kerf::output
