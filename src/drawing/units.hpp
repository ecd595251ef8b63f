#pragma once

#include <optional>
#include <string_view>

namespace kerf::drawing {

inline constexpr double kMmAnInch = 25.4;
inline constexpr double kDpi = 96;  ///< px an inch, as CSS has it

/// How long a unit of Reading::unit is: mm cm m in ft pt pc px um (and q, a quarter of a mm).
/// Small letters; none for other words. `dpi` is px an inch.
[[nodiscard]] std::optional<double> mm_of_unit(std::string_view unit, double dpi = kDpi);

}  // namespace kerf::drawing
