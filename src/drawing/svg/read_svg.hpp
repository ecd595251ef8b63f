#pragma once

#include <string>

#include "base/source_file.hpp"
#include "drawing/canvas.hpp"

namespace kerf::drawing {

/// Draws an SVG file. Zero is the lower left corner of its page. Pictures that it names are read
/// from `folder` alone, never through a link; empty: none are. What is wrong is told on the canvas
/// with the line and column of its tag, and what is not drawn is counted there.
void read_svg(const base::SourceFile& file, base::FileId id, Canvas& canvas,
              const std::string& folder = {});

}  // namespace kerf::drawing
