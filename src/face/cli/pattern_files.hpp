#pragma once

#include "base/diagnostic.hpp"
#include "base/source_file.hpp"
#include "drive/pattern/codec.hpp"
#include "face/cli/commands.hpp"

namespace kerf::cli {

// What the commands of `kerf pattern` share.

/// The file of the command, the only one of its set.
inline constexpr base::FileId kPatternFile{0};

/// How the bytes are to be read and written; `usual` is the order when none was asked for.
[[nodiscard]] drive::PatternFormat format_of(const PatternOptions& options, drive::ByteOrder usual);

/// Says on standard error what is wrong with the file. Returns the exit status of a wrong file.
ExitStatus report(const base::Diagnostic& diagnostic, const base::SourceSet& sources,
                  DiagnosticFormat format);

[[nodiscard]] ExitStatus replay(const PatternOptions& options, const base::SourceSet& sources);

}  // namespace kerf::cli
