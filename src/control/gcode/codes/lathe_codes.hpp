#pragma once

#include "control/gcode/codes/code_table.hpp"

namespace kerf::control {

/// Codes of a lathe in G-code system 'A', 'B' or 'C' (docs/dialect/turning.md).
[[nodiscard]] const CodeTable& lathe_codes(char system);

}  // namespace kerf::control
