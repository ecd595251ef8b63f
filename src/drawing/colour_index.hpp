#pragma once

#include "drawing/drawing.hpp"

namespace kerf::drawing {

inline constexpr int kByBlock = 0;
inline constexpr int kByLayer = 256;
inline constexpr int kForeground = 7;  ///< white on black, which is what is drawn without a colour

/// The colour of a number from 1 to 255 of the index of DXF; of others that of 7. Nine have names,
/// the next are 24 hues of 15 degrees in five shades, pure and half as pure, the last six greys.
[[nodiscard]] Colour colour_of_index(int index);
/// The number from 1 to 255 whose colour is nearest; the smallest of equals. Black is 7,
/// which is black on white.
[[nodiscard]] int nearest_index(Colour colour);

}  // namespace kerf::drawing
