#pragma once

#include "base/source_file.hpp"
#include "drawing/canvas.hpp"

namespace kerf::drawing {

/// Draws a file that is a PNG or JPEG, with its lower left corner at zero, on the layer of its
/// name: as large as Reading::unit (a pixel), Reading::dpi or its density says, else at 96 dpi with
/// DRAW_UNIT and Image::size_is_known false. A damaged one is IMAGE_BAD.
void read_image(const base::SourceFile& file, base::FileId id, Canvas& canvas);

}  // namespace kerf::drawing
