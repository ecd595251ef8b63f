#pragma once

#include <string>

#include "planner/linkage.hpp"
#include "random_path.hpp"

namespace kerf::test {

/// Cuts a path into cells and looks at many places of each whether its bounds hold there. A
/// sentence about the first that does not, or nothing.
[[nodiscard]] std::string check_cells(const RandomPath& path, const planner::Linkage& linkage);

}  // namespace kerf::test
