#pragma once

#include "base/language.hpp"

namespace kerf::records {

/// Motion records: what --motion writes.
[[nodiscard]] const base::Language& language();

}  // namespace kerf::records
