#pragma once

#include <vector>

#include "geometry/contour/internal/raw_offset.hpp"

namespace kerf::contour {

/// The edges of a closed contour, those that are no longer than kSame_mm left out: the next begins
/// where the last that was taken ends.
[[nodiscard]] std::vector<Link> chain_of(const Contour& contour);

/// Forth along a path and back: a closed chain with the path on its left, or two where the path is
/// closed.
[[nodiscard]] std::vector<std::vector<Link>> chains_round(const Contour& path);

}  // namespace kerf::contour
