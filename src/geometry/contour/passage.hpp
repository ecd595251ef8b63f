#pragma once

#include <span>
#include <vector>

#include "geometry/contour/region.hpp"

namespace kerf::contour {

/// What edges pass over that move without turning, each by way.from first and on along the line or
/// arc `way`, which turns by no more than half a circle: closed contours that together go round
/// each point counterclockwise as often as an edge comes over it, and never clockwise. With the
/// loops of a region at the beginning of its way they wind round all that it sweeps, however it is
/// shaped, and with lines and arcs only.
///
/// An edge and a way are two curves, and what one passes over is their sum, point by point. Where
/// their tangents are parallel the sum folds: the parts between have one sense each, and end in the
/// curves of both or, where two arcs fold, in an arc of the sum or the difference of their radii.
[[nodiscard]] std::vector<Contour> passage(std::span<const Edge> edges, const Edge& way);

/// The same with all edges of the region and its loops at the beginning.
[[nodiscard]] std::vector<Contour> passage(const Region& region, const Edge& way);

/// Whether a loop goes round counterclockwise and never bends to the right.
[[nodiscard]] bool is_convex(const Contour& loop);
/// What a convex loop sweeps along a line, as one loop: passage() and the loop, but for what is
/// inside. Precondition: is_convex(), and the way is straight.
[[nodiscard]] Contour convex_passage(const Contour& loop, const Edge& way);

/// A region by what closed contours that wind >= 0 everywhere go round, and what they do not.
struct Division {
  Region inside;
  Region outside;
};
/// Edges along the contours have their owners, others those of the region.
[[nodiscard]] Division divide(const Region& region, const std::vector<Contour>& by);

/// All that closed contours go round that wind >= 0 everywhere.
[[nodiscard]] Region covered(const std::vector<Contour>& loops);

}  // namespace kerf::contour
