#pragma once

#include <optional>

#include "stock/field/columns.hpp"
#include "stock/field/field_tool.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock::field {

/// The first t in [0, 1] of a straight way at which a tool's edges or another part touch material:
/// where a probe stops (stock.md §5, G31). To 1e-9 of the way's length on each column; walls of the
/// stock are where the columns are. nullopt: it touches nothing.
[[nodiscard]] std::optional<double> first_touch(const Columns& columns, const FieldTool& tool,
                                                const StraightWay& way);

}  // namespace kerf::stock::field
