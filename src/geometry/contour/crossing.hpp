#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "geometry/contour/contour.hpp"

namespace kerf::contour {

/// An edge of several contours.
struct EdgeName {
  std::size_t contour = 0;
  std::size_t edge = 0;

  friend auto operator<=>(const EdgeName&, const EdgeName&) = default;
};

/// A point that two edges have in common and that is not where one leads on to the other.
struct Meeting {
  EdgeName first{};
  EdgeName second{};  ///< > first
  Vec2 point{};
  bool is_crossing =
      false;  ///< inside of both, in two directions; else they touch, or run together
};

/// Where sound closed contours meet themselves and each other: a crossing if there is any, of
/// several the one of the least edges. Ends that are no farther from each other than `tolerance`
/// are one. Of what meets in more than some places for each edge not all are looked at: it costs n
/// log n, whatever the contours are.
[[nodiscard]] std::optional<Meeting> meeting_of(std::span<const Contour> contours,
                                                double tolerance);

/// True when each edge has the inside of `outer`, but outside of all `holes`, on one side and the
/// outside on the other: what meets does so in points, holes lie inside and apart. It costs as much
/// as the number of places in which they meet.
[[nodiscard]] bool bound_one_area(const Contour& outer, std::span<const Contour> holes);

}  // namespace kerf::contour
