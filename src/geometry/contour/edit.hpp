#pragma once

#include <cstddef>
#include <optional>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "geometry/contour/contour.hpp"

namespace kerf::contour {

/// The point nearest to `near` in which the whole lines and circles of two edges meet.
[[nodiscard]] std::optional<Vec2> meeting_point(const Edge& first, const Edge& second, Vec2 near);

/// The edge trimmed or extended along its line or circle, in its direction, until it begins or ends
/// in `point`, which lies on that.
[[nodiscard]] Edge with_start(const Edge& edge, Vec2 point);
[[nodiscard]] Edge with_end(const Edge& edge, Vec2 point);

/// Both trimmed or extended to their meeting point nearest to the end of the first and the
/// beginning of the second; nothing when they do not meet.
[[nodiscard]] std::optional<std::pair<Edge, Edge>> join(const Edge& first, const Edge& second);

/// An arc of `radius` > 0 that touches two edges, or their lines and circles beyond the ends: from
/// the first to the second, the short way. Of all of them the one whose centre is nearest to
/// `near`.
[[nodiscard]] std::optional<Edge> touching_arc(const Edge& first, const Edge& second, double radius,
                                               Vec2 near);

/// Why a corner cannot be rounded or cut: edge number `edge` would need the length `needs_mm` for
/// it, and has `has_mm`. Needs are infinite where nothing touches both edges.
struct DoesNotFit {
  std::size_t edge = 0;
  double needs_mm = 0;
  double has_mm = 0;
};
using Edited = tl::expected<Contour, DoesNotFit>;

/// The contour with an arc of `radius` > 0 in place of the corner at vertex `corner`, which has an
/// edge before and one behind it. Where these go on smoothly there is no corner, and nothing
/// changes.
[[nodiscard]] Edited fillet(const Contour& contour, std::size_t corner, double radius);
/// With a line between the points that are `before` > 0 from the corner along the edge that leads
/// to it, and `after` > 0 along the one behind; along an arc they are lengths of it.
[[nodiscard]] Edited chamfer(const Contour& contour, std::size_t corner, double before,
                             double after);

}  // namespace kerf::contour
