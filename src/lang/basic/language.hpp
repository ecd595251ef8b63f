#pragma once

#include "base/language.hpp"

namespace kerf::basic {

/// Laser BASIC.
[[nodiscard]] const base::Language& language();

}  // namespace kerf::basic
