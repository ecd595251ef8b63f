#pragma once

#include <string_view>

#include "drawing/font/font.hpp"

namespace kerf::drawing {

/// A file of letters from the blank (32) on, a record each: five columns of a number, three of how
/// many pairs of letters follow, and these pairs: first the left and right edge, then points, x and
/// y (down) as letters from 'R'; " R" lifts the pen. Records go on over ends of lines.
/// Capitals are as high as its H, or 21.
[[nodiscard]] base::Outcome<std::unique_ptr<Font>> read_hershey(std::string_view bytes,
                                                                const std::string& name);

}  // namespace kerf::drawing
