#pragma once

#include "features/path/recording.hpp"
#include "geometry/contour/contour.hpp"

namespace kerf::features {

/// A closed wall, each edge with the row as owner that has cut it, without what rounded words leave
/// on it: where passes end at a wall that another row has cut, or go along it, they stand out by a
/// thousandth. What lies so near beside a row that goes farther is that row's wall.
[[nodiscard]] contour::Contour smooth_wall(const Recording& recording,
                                           const contour::Contour& wall);

}  // namespace kerf::features
