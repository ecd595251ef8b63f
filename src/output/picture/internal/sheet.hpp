#pragma once

#include <string>

#include "output/picture/drawing/display_list.hpp"
#include "output/picture/internal/cut_recorder.hpp"
#include "output/picture/internal/path_recorder.hpp"
#include "output/picture/internal/turning_recorder.hpp"

namespace kerf::output::plot {

/// The whole picture of a recorded path: title, isometric view to the left, view from above to the
/// right, legend below. 1600 units wide and as high as the views need. A machine without Y gets one
/// wide view, a lathe, of which there is `turning`, its half section. With `cuts` they are coloured
/// by their values, and the legend has the scale.
[[nodiscard]] DisplayList draw_sheet(const PathRecorder& recorder, const TurningRecorder* turning,
                                     const CutRecorder* cuts, const std::string& title);

}  // namespace kerf::output::plot
