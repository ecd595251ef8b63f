#pragma once

#include <cstddef>
#include <vector>

#include "drawing/cleaning.hpp"

namespace kerf::drawing {

struct Joined {
  std::vector<Chain> chains;
  std::size_t joined = 0;
  std::size_t gaps = 0;
};

/// Open chains of one layer whose ends are within `join_mm` become longer ones. An end that is left
/// and has another left one within 10 times as much is told as DRAW_GAP.
[[nodiscard]] Joined join_ends(std::vector<Chain> chains, const Drawing& drawing, double join_mm,
                               Canvas& canvas);

}  // namespace kerf::drawing
