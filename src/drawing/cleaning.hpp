#pragma once

#include <cstddef>
#include <vector>

#include "drawing/canvas.hpp"
#include "drawing/drawing.hpp"

namespace kerf::drawing {

/// Entities that were joined; each edge's owner is the entity that it comes from.
struct Chain {
  contour::Contour path;
  EntityId entity = 0;  ///< of its segments the first one of the files
};

struct CleaningRules {
  double same_mm = 0.005;  ///< a shorter path is nothing; ends and bulges that differ less are one
  double join_mm = 0.02;   ///< ends that are no farther apart are joined
};

struct Cleaned {
  std::vector<Chain> chains;  ///< in the order of their first segments in the files
  std::vector<Point> points;  ///< also paths that have one
  std::size_t zero_length = 0;
  std::size_t duplicates = 0;
  std::size_t joined = 0;  ///< places at which two ends became one
  std::size_t gaps = 0;    ///< told as DRAW_GAP
};

/// In this order: paths that are shorter than `same_mm` go; of paths of one layer that are the same
/// the first stays; ends on one layer that are within `join_mm` become one in the middle of both,
/// nearest ones first and, where more than two meet, those that turn least; a chain that comes back
/// to its beginning is closed. As n log n.
[[nodiscard]] Cleaned clean(const Drawing& drawing, const CleaningRules& rules, Canvas& canvas);

}  // namespace kerf::drawing
