#pragma once

#include <string_view>

#include "base/result.hpp"
#include "drawing/canvas.hpp"

namespace kerf::drawing {

/// A lens about zero, by its widths.
struct LensShape {
  enum class Kind : std::uint8_t { round, oval, box };
  Kind kind = Kind::round;
  double across_mm = 0;  ///< along X, above 0
  double high_mm = 0;    ///< along Y, above 0; of round the same
  double radius_mm = 0;  ///< of a box's corners, from 0 to half of the shorter side
};

/// Whether a word names such a shape in place of a file.
[[nodiscard]] bool is_lens_shape(std::string_view word);
/// lens:round:D, lens:oval:A,B and lens:box:A,B,R. Failure (usage): it is none of them, or a
/// measure is out of range.
[[nodiscard]] base::Outcome<LensShape> read_lens_shape(std::string_view word);
/// As a file of its own on kLensLayer.
void draw_lens_shape(const LensShape& shape, base::FileId id, Canvas& canvas);

}  // namespace kerf::drawing
