#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "base/source_file.hpp"
#include "drawing/canvas.hpp"

namespace kerf::job {

/// Reads drawings one after the other, and keeps them among `sources`. A format is told by the
/// file's bytes, then by its ending: what is none is a finding (DRAW_FORMAT). Failure (input): a
/// file cannot be opened.
[[nodiscard]] base::Outcome<void> read_drawings(const std::vector<std::string>& names,
                                                double most_seconds, base::SourceSet& sources,
                                                drawing::Canvas& canvas);

}  // namespace kerf::job
