#pragma once

#include "base/source_file.hpp"
#include "drawing/canvas.hpp"

namespace kerf::drawing {

/// The layer of what is read here.
inline constexpr std::string_view kLensLayer = "lens";

/// Draws the outline that a lens trace (records of OMA/VCA, format 1) holds, seen from the front,
/// mm about its own zero. Of traces of both sides that of Reading::lens_side is drawn, or the
/// first; where that side alone is asked for which the file does not have, the other is mirrored
/// (x -> -x). Findings: TRACE_FORMAT, TRACE_COUNT, TRACE_BOX.
void read_trace(const base::SourceFile& file, base::FileId id, Canvas& canvas);

}  // namespace kerf::drawing
