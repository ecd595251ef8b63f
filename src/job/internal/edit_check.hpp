#pragma once

#include "features/path/recording.hpp"
#include "features/tree/tree.hpp"
#include "job/edit_run.hpp"
#include "job/internal/edit_planner.hpp"

namespace kerf::job {

/// Compares what an edited program machines with what was asked (features-contract §9): layers that
/// were edited come back with their contours, all others, and all holes, as they were.
[[nodiscard]] EditReport::Verified compare_edited(const features::Recording& recording,
                                                  const features::Tree& before,
                                                  const features::Tree& after,
                                                  const EditPlan& plan);

/// Under which names the edited layers are found again.
[[nodiscard]] std::vector<EditReport::Renamed> renamed_layers(const features::Tree& after,
                                                              const EditPlan& plan);

}  // namespace kerf::job
