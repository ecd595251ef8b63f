#pragma once

#include <optional>
#include <vector>

#include "features/rewrite/contour_chain.hpp"
#include "features/rewrite/planned_row.hpp"

namespace kerf::features {

/// Where rows meet a contour that is another one now.
struct MovedEnd {
  contour::Vec2 was{};
  contour::Vec2 is{};
  double turned_rad = 0;  ///< by which the element has turned that they begin or end along
};

/// What rows along a contour become for another one. Elements may come in and go.
struct FollowedContour {
  std::vector<PlannedRow> rows{};  ///< those that stay keep their blocks
  MovedEnd begin{};
  MovedEnd end{};
};

/// Rows whose blocks must stay the first and the last ones: something names them.
struct NamedEnds {
  bool first = false;
  bool last = false;
};

/// The rows of a chain along another contour, which is told in the sense that the old one was: from
/// the element that theirs has become, beginning where they began as far as that lies on it, to the
/// one that their last has become. Where one element was cut by several blocks it still is.
/// Nothing: it cannot be told where they begin or end now, or a named block would have to become
/// an arc of a line, or a line of an arc.
[[nodiscard]] std::optional<FollowedContour> followed(const Recording& recording,
                                                      const ContourChain& chain,
                                                      const contour::Contour& now, NamedEnds named);

}  // namespace kerf::features
