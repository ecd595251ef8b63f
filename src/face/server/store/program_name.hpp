#pragma once

#include <string>

#include "base/result.hpp"

namespace kerf::server {

/// Whether `name` can be a program of the library: the name of a file, never a path.
///
/// 1 to 100 bytes of UTF-8 without control characters, none of / \ : * ? " < > | (another system
/// shall be able to hold the file), no '.' or blank at the begin or end. So no name leads out of
/// the folder, is hidden, or is one of our temporary files. Failure (usage): what is wrong with it.
[[nodiscard]] base::Outcome<void> check_program_name(const std::string& name);

/// Names of machines and clients: 1 to 32 of A-Z a-z 0-9 - _. Failure (usage).
[[nodiscard]] base::Outcome<void> check_machine_name(const std::string& name);

}  // namespace kerf::server
