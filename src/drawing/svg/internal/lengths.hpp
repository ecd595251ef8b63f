#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "drawing/affine.hpp"

namespace kerf::drawing::svg {

/// A number with a unit: "12.5mm".
struct Length {
  double number = 0;
  std::string_view unit;  ///< as it is written; "%"; empty: user units
};

/// None: it is no length.
[[nodiscard]] std::optional<Length> length_of(std::string_view text);

/// What lengths are relative to.
struct Measures {
  Vec2 viewport;  ///< user units
  double font_size = 16;
  double dpi = 96;  ///< user units an inch
};

enum class Along : std::uint8_t { x, y, both };

/// In user units. None: its unit is unknown.
[[nodiscard]] std::optional<double> in_units(const Length& length, Along along,
                                             const Measures& measures);
/// Lengths parted by blanks and commas, up to the first that is none; at most 1000.
[[nodiscard]] std::vector<double> lengths_of(std::string_view text, Along along,
                                             const Measures& measures);

}  // namespace kerf::drawing::svg
