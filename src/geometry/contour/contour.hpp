#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/contour/edge.hpp"

namespace kerf::contour {

/// Where an edge begins; what else it has is the edge's that leads from here to the next vertex.
struct Vertex {
  Vec2 point;
  double bulge = 0;
  std::uint32_t owner = 0;

  friend bool operator==(const Vertex&, const Vertex&) = default;
};

/// Lines and arcs, each beginning where the one before ends. A closed one leads from the last
/// vertex to the first; the last vertex of an open one has no edge. A full circle needs two
/// vertices.
struct Contour {
  std::vector<Vertex> vertices;
  bool is_closed = true;

  friend bool operator==(const Contour&, const Contour&) = default;
};

[[nodiscard]] std::size_t edge_count(const Contour& contour);
[[nodiscard]] Edge edge_of(const Contour& contour, std::size_t index);

/// True when every coordinate and bulge is a number, none beyond kFarthest_mm, and no arc so flat
/// that its radius is none.
[[nodiscard]] bool is_sound(const Contour& contour);

/// mm², positive when it goes round counterclockwise; of an open contour as if a line closed it.
[[nodiscard]] double area(const Contour& contour);
[[nodiscard]] double length(const Contour& contour);
[[nodiscard]] Box extents(const Contour& contour);
[[nodiscard]] bool is_counterclockwise(const Contour& contour);
[[nodiscard]] Contour reversed(const Contour& contour);

/// A place on a contour: an edge, and the share of its length.
struct Place {
  std::size_t edge = 0;
  double share = 0;
};
[[nodiscard]] Vec2 point_at(const Contour& contour, Place place);
/// `distance` mm from the beginning, clamped to its ends. The contour has an edge.
[[nodiscard]] Place place_at_length(const Contour& contour, double distance);
[[nodiscard]] Vec2 midpoint(const Contour& contour);
/// The place nearest to `point`; the first of equals. The contour has an edge.
[[nodiscard]] Place nearest_place(const Contour& contour, Vec2 point);
[[nodiscard]] double distance(const Contour& contour, Vec2 point);

enum class Side : std::uint8_t { outside, border, inside };
/// Inside is what a closed contour goes round, any number of times but 0. Border: no farther from
/// it than `tolerance`. Linear in the number of edges.
[[nodiscard]] Side side_of(const Contour& contour, Vec2 point, double tolerance);
/// How often a closed contour goes round a point that is not on it.
[[nodiscard]] int winding(const Contour& contour, Vec2 point);

}  // namespace kerf::contour
