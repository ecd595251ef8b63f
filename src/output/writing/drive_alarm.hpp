#pragma once

#include "base/diagnostic.hpp"
#include "base/source_file.hpp"
#include "motion/mark.hpp"

namespace kerf::output {

/// A finding that knows no more of its place than file and line, with where that line begins. Reads
/// the file up to there.
[[nodiscard]] base::Diagnostic at_line(base::Diagnostic finding, const base::SourceSet& sources);

/// What a drive could not do, at the source line of the motion that was under way. Reads that file
/// up to the line.
[[nodiscard]] base::Diagnostic at_mark(base::Diagnostic alarm, const motion::Mark& mark,
                                       const base::SourceSet& sources);

}  // namespace kerf::output
