#pragma once

#include <vector>

#include "features/milling/stroke.hpp"

namespace kerf::features {

/// A stroke of a thread mill, from a rapid to the next: the helix in it, and all its rows.
struct ThreadRun {
  HelixRun helix{};  ///< rows and visit are those of the stroke; radius that of the path
  bool is_found = false;
};

/// The strokes of an operation by a thread mill, each with its helix, up or down.
[[nodiscard]] std::vector<ThreadRun> thread_runs_of(const Recording& recording,
                                                    const Operation& operation);

}  // namespace kerf::features
