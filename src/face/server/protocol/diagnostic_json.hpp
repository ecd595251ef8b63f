#pragma once

#include "base/diagnostic.hpp"
#include "base/source_file.hpp"
#include "face/server/protocol/json.hpp"

namespace kerf::server {

/// A diagnostic as events and answers have it: `{severity, code, message, file, line, column,
/// length, program, cause, remedy}`. The cause is what docs/errors.md says of its code, the remedy
/// what was probably meant here.
[[nodiscard]] Json diagnostic_json(const base::Diagnostic& diagnostic,
                                   const base::SourceSet& sources);

/// The last part of a path: what a client is told of where a file lies.
[[nodiscard]] std::string file_label(const std::string& path);

}  // namespace kerf::server
