#pragma once

#include "base/language.hpp"

namespace kerf::drive {

/// Listings of patterns.
[[nodiscard]] const base::Language& pattern_language();

}  // namespace kerf::drive
