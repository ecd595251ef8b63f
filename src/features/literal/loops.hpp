#pragma once

#include <vector>

#include "features/path/recording.hpp"
#include "features/tree/feature.hpp"

namespace kerf::features {

/// Loops among rows that follow each other in the plane, and the rows between.
struct LoopsOfRows {
  std::vector<Loop> loops{};
  std::vector<std::uint32_t> links{};  ///< that are part of no loop, in their order
};

/// Follows the rows: a row that ends where an earlier one began, since the last loop, closes one; a
/// row that goes round in a circle is one by itself. `rows` in their order; where one does not
/// begin where the one before ended, the tool has been elsewhere, and no loop goes across.
[[nodiscard]] LoopsOfRows loops_of(const Recording& recording,
                                   const std::vector<std::uint32_t>& rows);

}  // namespace kerf::features
