#pragma once

#include "features/plan/edit_plan.hpp"
#include "output/features/edit_preview.hpp"

namespace kerf::job {

/// Adds where a plan cuts more, where less, and what of its contours the tool does not reach: of a
/// lathe in its half section, X being diameters.
void add_edited_areas(const features::Recording& recording, const features::Tree& tree,
                      const features::EditPlan& plan, output::EditPreview::Cut& cut);

}  // namespace kerf::job
