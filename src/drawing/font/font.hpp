#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "geometry/vec2.hpp"

namespace kerf::drawing {

using geometry::Vec2;

/// A letter's part, on from where the one before ended.
struct Stroke {
  enum class Kind : std::uint8_t { begin, line, arc, quadratic, cubic, close } kind{};
  Vec2 to{};
  Vec2 first{};  ///< control points of curves
  Vec2 second{};
  double bulge = 0;  ///< of an arc, as contour::Edge has it
};

/// A letter. Its unit is the height of a capital; (0, 0) is on the base line at its left.
struct Glyph {
  double advance = 0;  ///< to the next letter
  std::vector<Stroke> strokes;
};

/// Letters by their code in Unicode. What is looked up is kept.
class Font {
 public:
  Font() = default;
  virtual ~Font() = default;
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  /// Null: the font does not have it. Valid as long as the font.
  [[nodiscard]] virtual const Glyph* find(char32_t code) = 0;
  /// How much nearer (< 0) two letters stand.
  [[nodiscard]] virtual double kerning(char32_t, char32_t) { return 0; }
  /// What of an advance is no part of the letter: the last one of a line does not have it.
  [[nodiscard]] virtual double gap() const { return 0; }
  /// How far letters go below the base line, >= 0.
  [[nodiscard]] virtual double depth() const { return 0; }
};

/// "kerf-line", or a file: .jhf (Hershey), else what FreeType reads. Failure (input): there is no
/// such file, or it is no font; the sentence says which.
[[nodiscard]] base::Outcome<std::unique_ptr<Font>> open_font(const std::string& name);
/// The same of bytes that are there; `name` is for sentences, and its ending tells a .jhf.
[[nodiscard]] base::Outcome<std::unique_ptr<Font>> font_of_bytes(std::string bytes,
                                                                 const std::string& name);
/// Our own: single lines. Capitals are exactly 1 high.
[[nodiscard]] std::unique_ptr<Font> line_font();

}  // namespace kerf::drawing
