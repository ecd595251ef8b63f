#pragma once

#include "features/path/recording.hpp"

namespace kerf::features {

/// The recording as its blocks command it: rows under G41 and G42 end where the words of their
/// block say, not where the control leads the tool beside the contour. What the control puts in at
/// corners goes nowhere, and the last row of a block is the one that it commands. Rows keep their
/// places. A stretch under compensation whose corners cannot be told stays as it is.
[[nodiscard]] Recording as_programmed(const Recording& recording);

}  // namespace kerf::features
