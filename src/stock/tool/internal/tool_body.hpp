#pragma once

#include <string>

#include "stock/tool/tool.hpp"

namespace kerf::stock {

/// Why a rotating tool, or one with an insert, cannot be: a sentence without a full stop, or
/// nothing. Precondition: its measures are in range, those that it needs are there.
[[nodiscard]] std::string objection_to_body(const Tool& tool);
[[nodiscard]] std::string objection_to_insert(const Tool& tool);

}  // namespace kerf::stock
