#pragma once

#include "drawing/font/font.hpp"

namespace kerf::drawing {

/// A font of outlines, which FreeType reads: each letter closed contours of its curves, unhinted.
/// Capitals are as high as the font says, or as its H.
[[nodiscard]] base::Outcome<std::unique_ptr<Font>> read_outlines(std::string bytes,
                                                                 const std::string& name);

}  // namespace kerf::drawing
