#pragma once

#include <span>
#include <string_view>

namespace kerf::drawing {

/// A letter of kerf-line as it is written: see line_glyphs.cpp.
struct LineGlyph {
  char32_t code = 0;
  std::string_view strokes;
  double width = 0;  ///< 0: as wide as its strokes
};
/// A letter that is another one with a mark above or below it.
struct MarkedGlyph {
  char32_t code = 0;
  char32_t base = 0;
  char mark = 0;  ///< of line_marks()
};
/// A letter that looks like another one.
struct SameGlyph {
  char32_t code = 0;
  char32_t as = 0;
};

[[nodiscard]] std::span<const LineGlyph> line_glyphs();
/// By their `code`, a character; about x = 0, from the height that they stand at.
[[nodiscard]] std::span<const LineGlyph> line_marks();
[[nodiscard]] std::span<const MarkedGlyph> marked_glyphs();
[[nodiscard]] std::span<const SameGlyph> same_glyphs();

}  // namespace kerf::drawing
