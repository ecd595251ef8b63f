#pragma once

#include "features/path/blank.hpp"
#include "features/path/tolerance.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// Of feeds that cut nothing and go down to `lowest`: what nobody has described may be higher.
[[nodiscard]] inline Unrecognised::Why why_air(const Blank& blank, double lowest) {
  const bool is_above = lowest >= blank.top - kSameZ_mm;
  return is_above && !blank.is_known ? Unrecognised::Why::above_assumed_stock
                                     : Unrecognised::Why::air;
}

}  // namespace kerf::features
