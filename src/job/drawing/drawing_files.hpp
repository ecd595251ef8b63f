#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "base/source_file.hpp"
#include "drawing/canvas.hpp"

namespace kerf::job {

/// Reads drawings one after the other; each gets the FileId of its place. A format is told by the
/// file's bytes, then by its ending: what is none is a finding (DRAW_FORMAT). Failure (input): a
/// file cannot be opened.
[[nodiscard]] base::Outcome<std::vector<std::shared_ptr<base::SourceFile>>> read_drawings(
    const std::vector<std::string>& names, drawing::Canvas& canvas);

}  // namespace kerf::job
