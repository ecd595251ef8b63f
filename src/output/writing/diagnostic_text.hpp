#pragma once

#include <string>

#include "base/diagnostic.hpp"
#include "base/source_file.hpp"

namespace kerf::output {

/// A diagnostic as a compiler would print it: `path:line:column: error: PS0112 …`, then the source
/// line with a caret under the offending text, then the hint. Ends with a line end.
[[nodiscard]] std::string diagnostic_text(const base::Diagnostic& diagnostic,
                                          const base::SourceSet& sources);

/// The same as one JSON object on a line of its own.
[[nodiscard]] std::string diagnostic_json(const base::Diagnostic& diagnostic,
                                          const base::SourceSet& sources);

/// "error", "warning", "note".
[[nodiscard]] const char* severity_name(base::Severity severity);

/// Name of the file that a diagnostic speaks of; empty without one.
[[nodiscard]] std::string file_name(const base::Diagnostic& diagnostic,
                                    const base::SourceSet& sources);

/// `text` as valid UTF-8 without control characters: other bytes read '?'.
[[nodiscard]] std::string printable(const std::string& text);

}  // namespace kerf::output
