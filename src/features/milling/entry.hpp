#pragma once

#include "features/path/recording.hpp"
#include "features/tree/feature.hpp"

namespace kerf::features {

struct ShapedLevel;

/// How the tool came into the first run of a level.
[[nodiscard]] Entry entry_of(const Recording& recording, const ShapedLevel& shaped);

}  // namespace kerf::features
