#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/contour/contour.hpp"

namespace kerf::contour {

/// An area: simple loops that do not cross each other nor themselves and have no edge in common,
/// what is inside on the left of each. Outer ones go counterclockwise, holes clockwise, islands in
/// holes are outer ones again. Loops may touch in points. What makes regions: region_of() and the
/// operations of this room; every one of them expects its regions to be as they made them.
struct Region {
  std::vector<Contour> loops;

  [[nodiscard]] bool is_empty() const { return loops.empty(); }
  friend bool operator==(const Region&, const Region&) = default;
};

/// What the closed contours among `contours` go round, each by itself in any direction and however
/// often, all together. Nothing of contours that are not sound.
[[nodiscard]] Region region_of(const std::vector<Contour>& contours);
[[nodiscard]] Region region_of(const Contour& contour);
/// A disc: the counterclockwise circle as two halves.
[[nodiscard]] Region disc(Vec2 centre, double radius, std::uint32_t owner = 0);

[[nodiscard]] double area(const Region& region);
/// Of all borders.
[[nodiscard]] double length(const Region& region);
[[nodiscard]] Box extents(const Region& region);
[[nodiscard]] std::size_t vertex_count(const Region& region);
[[nodiscard]] double distance_to_border(const Region& region, Vec2 point);
/// As side_of() a contour.
[[nodiscard]] Side side_of(const Region& region, Vec2 point, double tolerance);

/// For each loop the one that it lies in directly: a hole its outer loop, an island the hole.
[[nodiscard]] std::vector<std::optional<std::size_t>> parents(const Region& region);

}  // namespace kerf::contour
