#pragma once

#include "base/language.hpp"

namespace kerf::teach {

/// Taught points.
[[nodiscard]] const base::Language& language();

}  // namespace kerf::teach
