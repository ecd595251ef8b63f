#pragma once

#include <string>

#include "base/result.hpp"

namespace kerf::server {

/// Makes a folder that only this account reads and writes (0700), with those above it where they
/// are missing. One that is there is closed to the others. Returns whether it had been open to
/// them. Failure (output): it cannot be made, or is open and belongs to somebody else.
[[nodiscard]] base::Outcome<bool> make_private_folder(const std::string& folder);

/// Whether files of this name were begun by a server that was killed: ".NAME.XXXXXX", as
/// base::OutputFile names what is not complete.
[[nodiscard]] bool is_unfinished(const std::string& file_name);

/// Removes the files of a folder whose writer was killed. Precondition: nobody writes there.
void remove_unfinished(const std::string& folder);

}  // namespace kerf::server
