#pragma once

#include <functional>
#include <string>

#include "process/recipe_file.hpp"

namespace kerf::process {

/// Where a key stands: "operation.0.ton_ms", operations counted from 0. Of a table where it begins.
using KeyPlace = std::function<base::Place(const std::string& path)>;

[[nodiscard]] Diagnostics check_recipe(const Recipe& recipe, const KeyPlace& place);

}  // namespace kerf::process
