#pragma once

#include "base/language.hpp"

namespace kerf::gcode {

/// Word-address G-code with Custom Macro B.
[[nodiscard]] const base::Language& language();

}  // namespace kerf::gcode
