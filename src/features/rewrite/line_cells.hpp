#pragma once

#include <vector>

#include "features/rewrite/old_lines.hpp"

namespace kerf::features {

/// A new pass, ascending along its line.
struct NewPass {
  double line = 0;
  Interval part{};
};

/// Passes that can be cut one behind the other without leaving the work.
using Cell = std::vector<NewPass>;

/// Which lines clear a region that the centre of the tool may be in: the old ones as far as they
/// go, then as far apart. `reaches_end`: one goes along the far end.
[[nodiscard]] std::vector<double> new_lines(const OldLines& old, const contour::Region& before,
                                            const contour::Region& now, bool reaches_end);

/// Those along straight parts of its border between them, too, but for the ones that are there.
[[nodiscard]] std::vector<double> with_borders(std::vector<double> lines,
                                               const contour::Region& region, const Ruling& ruling);

/// Lines in a region, in cells: in each a line has one part, beside those of its neighbours alone.
[[nodiscard]] std::vector<Cell> cells_of(const contour::Region& region, const Ruling& ruling,
                                         const std::vector<double>& lines);

}  // namespace kerf::features
