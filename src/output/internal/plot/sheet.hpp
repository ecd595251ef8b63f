#pragma once

#include <string>

#include "output/internal/plot/display_list.hpp"
#include "output/internal/plot/path_recorder.hpp"
#include "output/internal/plot/speed_recorder.hpp"

namespace kerf::output::plot {

/// The whole picture of a recorded path: title, isometric view to the left, view from above to the
/// right, legend below. 1600 units wide and as high as the views need. A machine without Y gets one
/// wide view. With `speeds` the cuts are coloured by them, and the legend has their scale.
[[nodiscard]] DisplayList draw_sheet(const PathRecorder& recorder, const SpeedRecorder* speeds,
                                     const std::string& title);

}  // namespace kerf::output::plot
