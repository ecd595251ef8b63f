#pragma once

#include <optional>
#include <string_view>

#include "drawing/drawing.hpp"

namespace kerf::drawing::svg {

/// A colour of CSS: a name, #rgb, #rrggbb (with an alpha: #rgba, #rrggbbaa), rgb(), rgba(), hsl().
struct CssColour {
  Colour colour{};
  double alpha = 1;
};
[[nodiscard]] std::optional<CssColour> colour_of(std::string_view text);

}  // namespace kerf::drawing::svg
