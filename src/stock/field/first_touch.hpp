#pragma once

#include <optional>

#include "stock/field/columns.hpp"
#include "stock/sweep/ball_way.hpp"

namespace kerf::stock::field {

/// Where the ball of a probe first touches columns as they are: each fills its cell from its bottom
/// to its top (stock.md §5, G31). So a level face is met where it is, a wall within half a cell of
/// it; walls of a box, which are borders of cells, where they are.
[[nodiscard]] std::optional<double> first_touch(const Columns& columns, const BallWay& ball);

}  // namespace kerf::stock::field
