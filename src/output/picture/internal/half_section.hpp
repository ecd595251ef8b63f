#pragma once

#include <vector>

#include "output/picture/drawing/view.hpp"
#include "output/picture/internal/subject.hpp"
#include "output/picture/internal/turning_insert.hpp"
#include "output/picture/internal/turning_recorder.hpp"

namespace kerf::output::plot {

/// What the picture of a lathe program shows beside its path.
struct Turning {
  Turning(const Subject& subject, const TurningRecorder& recorder);

  const TurningRecorder& recorded;  ///< outlives this
  std::vector<ToolWay> ways;        ///< by the index of the pen
  std::vector<TurningInsert> inserts;
};

/// Where the half section of a path is seen: its box, the same on both sides of the axis.
[[nodiscard]] Box3 half_section_box(const Subject& subject);

/// Draws a lathe's path above the axis of rotation, what it leaves of the part on both sides, below
/// in section, and each tool's insert where it cut. The view is that of kLathe.
void draw_half_section(DisplayList& sheet, const View& view, const Subject& subject,
                       const Turning& turning);

/// For the legend: a piece of the part in section.
void draw_section_sample(DisplayList& sheet, const Rect& at);

}  // namespace kerf::output::plot
