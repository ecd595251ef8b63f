#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "drawing/canvas.hpp"
#include "job/drawing/draw_order.hpp"

namespace kerf::job {

/// Draws the words of the drawings and of the job, with the job's font, and returns them in their
/// order, those of the first copy. Where a text of the job differs from copy to copy, each has its
/// own. Without [text] the words of the drawings are told (SVG_TEXT). Failure (input): the font or
/// the file of the serial cannot be read.
[[nodiscard]] base::Outcome<std::vector<std::string>> draw_texts(const DrawOrder& order,
                                                                 drawing::Drawing& drawing,
                                                                 drawing::Canvas& canvas);

/// Behind a run that ended: the serial that the next one begins with is kept, where the job says
/// so. Failure: the file cannot be written.
[[nodiscard]] base::Outcome<void> keep_serials(const DrawOrder& order);

}  // namespace kerf::job
