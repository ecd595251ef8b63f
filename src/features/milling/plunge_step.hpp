#pragma once

#include "features/milling/material.hpp"
#include "features/milling/stroke.hpp"
#include "features/tree/hole.hpp"

namespace kerf::features {

/// The step of a hole that a plunge is.
[[nodiscard]] HoleStep step_of(const Recording& recording, const Material& material,
                               const stock::Tool& tool, const PlungeRun& plunge);

}  // namespace kerf::features
