#pragma once

#include <cstdint>

#include "geometry/contour/box.hpp"

namespace kerf::contour {

/// A line from `from` to `to`, mm, or an arc between them. `bulge` is the tangent of a quarter of
/// the swept angle, positive counterclockwise: 0 is a line, 1 half a circle. `owner` is the
/// caller's: what made this edge; every edge of a result has that of the edge it is a part of, or
/// beside.
struct Edge {
  Vec2 from;
  Vec2 to;
  double bulge = 0;
  std::uint32_t owner = 0;

  friend bool operator==(const Edge&, const Edge&) = default;
};

/// Of an arc; a line has none.
[[nodiscard]] Vec2 centre(const Edge& edge);
[[nodiscard]] double radius(const Edge& edge);

/// Radians, positive counterclockwise; 0 of a line.
[[nodiscard]] double sweep_rad(const Edge& edge);
[[nodiscard]] double length(const Edge& edge);
/// Between the edge and the lines from `origin` to its ends; positive when the edge goes round it
/// counterclockwise. Over all edges of a closed contour this is its area, whatever the origin.
[[nodiscard]] double area_about(const Edge& edge, Vec2 origin);
[[nodiscard]] Box extents(const Edge& edge);

/// The point at the share `share` in [0, 1] of the length.
[[nodiscard]] Vec2 point_at(const Edge& edge, double share);
/// The part between two shares of the length, `first` < `second`.
[[nodiscard]] Edge part(const Edge& edge, double first, double second);
[[nodiscard]] Edge reversed(const Edge& edge);
/// Directions of travel at the ends, as long as the chord.
[[nodiscard]] Vec2 tangent_at_start(const Edge& edge);
[[nodiscard]] Vec2 tangent_at_end(const Edge& edge);

/// The point of the edge nearest to `point`, as a share of its length.
[[nodiscard]] double nearest_share(const Edge& edge, Vec2 point);
[[nodiscard]] double distance(const Edge& edge, Vec2 point);

/// How often the edge goes round `point` counterclockwise, in the sense that the sum over a closed
/// contour is its winding number: 1, 0 or -1 for each part of the edge that rises or falls past the
/// point on its right. A point on the edge belongs to one side of it.
[[nodiscard]] int winding(const Edge& edge, Vec2 point);

}  // namespace kerf::contour
