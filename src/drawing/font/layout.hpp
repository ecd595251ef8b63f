#pragma once

#include "drawing/canvas.hpp"
#include "drawing/font/font.hpp"

namespace kerf::drawing {

/// How a job sets words.
struct Lettering {
  double spacing = 1;     ///< times the way from letter to letter
  double line = 5.0 / 3;  ///< from line to line, heights of a capital
};

/// How wide the widest line of words is, heights of a capital.
[[nodiscard]] double width_of(std::string_view words, Font& font, const Lettering& lettering);

/// Draws words by the paths of their entity: lines below each other, each aligned for itself.
/// Across::aligned scales words to Text::width, Across::fit stretches them to it; left of it they
/// begin. A letter that the font lacks is TEXT_GLYPH and a box as wide as its H; bytes that are no
/// UTF-8 are such letters.
void draw_text(const Text& text, Font& font, const Lettering& lettering, Canvas& canvas);

}  // namespace kerf::drawing
