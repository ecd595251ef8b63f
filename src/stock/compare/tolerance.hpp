#pragma once

#include <cstddef>
#include <cstdint>

namespace kerf::stock::compare {

/// What a part has against a design, or against another part: it was cut into that, or it has
/// material left that is not there.
enum class Side : std::uint8_t { gouge, excess };
inline constexpr std::size_t kSides = 2;
[[nodiscard]] constexpr std::size_t index(Side side) { return static_cast<std::size_t>(side); }

struct Tolerance {
  double gouge_mm = 0.05;   ///< >= 0: what is cut into by no more is right
  double excess_mm = 0.05;  ///< >= 0
  [[nodiscard]] double of(Side side) const { return side == Side::gouge ? gouge_mm : excess_mm; }
  [[nodiscard]] double larger() const { return gouge_mm > excess_mm ? gouge_mm : excess_mm; }
};

}  // namespace kerf::stock::compare
