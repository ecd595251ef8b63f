#pragma once

#include <vector>

#include "features/plan/edit_plan.hpp"
#include "output/features/edit_preview.hpp"

namespace kerf::job {

/// The ways of the tool at feed that a plan makes, as contours are told: those of each layer at one
/// height together.
[[nodiscard]] std::vector<output::EditPreview::Paths> edited_paths(
    const features::Recording& recording, const features::Tree& tree,
    const features::EditPlan& plan);

}  // namespace kerf::job
