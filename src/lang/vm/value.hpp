#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace kerf::vm {

/// A value is a double or null. Null is one certain NaN; every operation of the machine checks that
/// its result is finite, so no calculation ever makes it.
inline constexpr double kNull = std::bit_cast<double>(std::uint64_t{0x7ff8'4b45'5246'0000});

[[nodiscard]] constexpr bool is_null(double value) { return value != value; }

/// `value`, or 0 for null.
[[nodiscard]] constexpr double zero_if_null(double value) { return value == value ? value : 0.0; }

/// True for every number that a program may hold: not null, not infinite.
[[nodiscard]] constexpr bool is_number(double value) {
  return value <= std::numeric_limits<double>::max() &&
         value >= std::numeric_limits<double>::lowest();
}

}  // namespace kerf::vm
