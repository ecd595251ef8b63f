#pragma once

#include <cstddef>
#include <vector>

#include "geometry/contour/region.hpp"

namespace kerf::stock::surface {

/// A corner of a loop of straight edges; the owner is that of the edge that begins here.
struct FlatPoint {
  geometry::Vec2 place;
  std::uint32_t owner = 0;
  /// Of a place on an arc: away from its centre, as long as the chords there are off.
  geometry::Vec2 outwards{};
};
using FlatLoop = std::vector<FlatPoint>;

/// The loops of a region with chords instead of arcs, no farther from them than `tolerance_mm`.
/// Where loops touch each other or themselves, the later corner gives way into the material by a
/// ten thousandth of a millimetre, so that no two are at one place. Loops of less than three
/// corners are left out.
[[nodiscard]] std::vector<FlatLoop> flat_loops(const contour::Region& region, double tolerance_mm);

/// Which loops bound one area together: its outer one first, which goes counterclockwise, then its
/// holes. In the order of the outer ones.
[[nodiscard]] std::vector<std::vector<std::size_t>> areas_of(const std::vector<FlatLoop>& loops);

}  // namespace kerf::stock::surface
