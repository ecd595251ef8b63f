#pragma once

#include "base/source_file.hpp"
#include "drawing/canvas.hpp"

namespace kerf::drawing {

/// Draws what a DXF shows from above in its model space, about its own zero. What cannot be drawn
/// is ignored with its reason, or a finding: DXF_BINARY, DXF_DWG, DXF_GROUP, DXF_TRUNCATED,
/// DXF_BLOCK, DXF_PLANE, DRAW_UNIT; what is whole is drawn all the same. Reads the file in blocks:
/// the memory is that of its blocks (in the sense of DXF), of the longest entity, and the drawing.
void read_dxf(const base::SourceFile& file, base::FileId id, Canvas& canvas);

}  // namespace kerf::drawing
